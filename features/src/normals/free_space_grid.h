/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Which cells of the box around some positions hold any, for tests of sight. */
class FreeSpaceGrid {
public:
  /** \param[in] positions at least one; outliers are cut off
   * \param[in] cell_size metres; enlarged if the grid would become too large
   */
  FreeSpaceGrid(const std::vector<Eigen::Vector3f>& positions, double cell_size);

  /** \brief In how many of the six axis directions each cell has an occupied one. */
  std::vector<std::uint8_t>
  enclosedDirections() const;

  /** \brief City-block distance of a cell to the nearest occupied one, in cells, at
   * most 255. */
  int
  clearance(std::size_t cell) const
  {
    return clearances_[cell];
  }

  /** \brief Tell whether no occupied cell lies between two places, but for those right
   * at the second. */
  bool
  sees(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const;

  /** \brief The cell of a place; of one far outside, a cell right beside the grid. */
  Eigen::Vector3i
  cellOf(const Eigen::Vector3d& position) const
  {
    return cellAt((position - origin_) / cell_size_);
  }

  bool
  contains(const Eigen::Vector3i& cell) const
  {
    return (cell.array() >= 0).all() && (cell.array() < shape_.array()).all();
  }

  std::size_t
  index(const Eigen::Vector3i& cell) const
  {
    return (static_cast<std::size_t>(cell.x()) * shape_.y() + cell.y()) * shape_.z() +
           cell.z();
  }

  Eigen::Vector3f
  center(const Eigen::Vector3i& cell) const
  {
    const Eigen::Vector3d middle = cell.cast<double>().array() + 0.5;
    return (origin_ + cell_size_ * middle).cast<float>();
  }

  const Eigen::Vector3i&
  shape() const
  {
    return shape_;
  }

  double
  cellSize() const
  {
    return cell_size_;
  }

private:
  /** \param[in] place in cells */
  Eigen::Vector3i
  cellAt(const Eigen::Vector3d& place) const
  {
    const Eigen::Array3d highest = shape_.array().cast<double>();
    const Eigen::Array3d inside = place.array().max(-1.0).min(highest);
    const Eigen::Array3i towards_zero = inside.cast<int>();
    return (towards_zero - (towards_zero.cast<double>() > inside).cast<int>()).matrix();
  }

  bool
  isOccupied(std::size_t cell) const
  {
    return clearances_[cell] == 0;
  }

  void
  sweep(int axis);

  Eigen::Vector3d origin_;
  double cell_size_ = 0;
  Eigen::Vector3i shape_;
  std::vector<std::uint8_t> clearances_; // of each cell
};

} // namespace pcl::indoor
