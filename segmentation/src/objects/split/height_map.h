/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** Least area of a surface that objects lie on, voxels. */
constexpr double min_object_surface = 64;

/** \brief Mean heights above a surface in the cells of a regular grid. */
class HeightMap {
public:
  /** \param[in] places on the surface; x and y count, the grid holds all of them */
  HeightMap(const std::vector<Eigen::Vector3d>& places, double cell_size);

  double
  cellCount() const
  {
    return cell_count_;
  }

  /** \return false if the place is outside of the grid */
  bool
  find(const Eigen::Vector2d& place, std::uint32_t& cell) const;

  void
  add(std::uint32_t cell, double height);

  /** \brief Find connected cells that rise above the others.
   * \return the number of its object, from 1, for each cell; 0 for all others
   */
  std::vector<std::uint32_t>
  findObjects();

  /** \brief Get the number of objects that were found. */
  std::size_t
  objectCount() const
  {
    return object_count_;
  }

private:
  using Cells = std::vector<std::uint32_t>;
  enum class State : std::uint8_t { Open, Visited, High };

  /** Allocate the grid when the first point comes: the caller first checks its size. */
  void
  prepare();

  template <typename Function>
  void
  forNeighbors(std::uint32_t cell, Function function) const;

  void
  smoothHeights();

  /** Height of the surface and its standard deviation, from the cells below it: no
   * object lies there. */
  bool
  measureSurface(double tolerance, double min_cells);

  /** The first cell and those connected to it, as far as take() takes them; it takes
   * none twice. */
  template <typename Take>
  Cells
  connected(std::uint32_t first, Take take) const;

  double
  meanHeight(std::uint32_t cell) const
  {
    return sums_[cell] / counts_[cell];
  }

  /** Height from which a cell is part of an object: a share of how high the raised
   * cells are. */
  double
  outlineOf(const Cells& raised) const;

  Cells
  largestAbove(double outline, const Cells& raised);

  double cell_size_;
  Eigen::Vector2d corner_;
  Eigen::Array2i shape_;
  double cell_count_;
  std::vector<double> sums_, heights_;
  std::vector<std::uint32_t> counts_;
  std::vector<State> states_;
  double surface_ = 0, deviation_ = 0;
  std::size_t object_count_ = 0;
};

} // namespace pcl::indoor
