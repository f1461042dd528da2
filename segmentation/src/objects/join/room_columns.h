/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/join/outline_kdop.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief What is seen of a room from above: upright columns, two voxels wide, and the
 * heights at which each has voxels, in steps of two voxels. Only columns with voxels
 * are kept. */
class RoomColumns {
public:
  /** \brief Make an empty room. */
  RoomColumns() = default;

  /** \param[in] voxels their places, metres, z up; at least one
   * \param[in] floor height of the floor, metres: the middle of the lowest step, which
   * also has what is lower. The highest of 64 steps also has what is higher.
   * \param[in] voxel_size metres */
  RoomColumns(const std::vector<Eigen::Vector3f>& voxels,
              double floor,
              double voxel_size);

  /** \brief Get how much of an outline has the floor in sight, m^2. Floor is what is in
   * the lowest two steps. */
  double
  areaOfFloor(const KDop16& outline) const;

  /** \brief From one height to another, in either order, metres. */
  struct Heights {
    double from = 0, to = 0;
  };

  /** \brief What is seen between two outlines, m^2. */
  struct Gap {
    double open = 0;   ///< nothing at the heights, but something below
    double filled = 0; ///< something at the heights
  };

  /** \brief Look at what is in the outline of two together, but in neither.
   * At the \a heights there may be something between the two. */
  Gap
  areaBetween(const KDop16& a, const KDop16& b, Heights heights) const;

private:
  struct Column {
    std::int32_t x, y;
    std::uint64_t heights; ///< a bit for each step, the lowest first
  };

  using Columns = std::vector<Column>;

  int
  stepOf(double height) const;

  double
  middleOf(std::int32_t cell, int axis) const;

  template <typename Function>
  void
  forRowsIn(const KDop16& outline, Function function) const;

  double size_ = 0; ///< of columns and steps, metres
  Eigen::Vector3d corner_ = Eigen::Vector3d::Zero();
  Columns columns_; ///< ascending by x and y
};

} // namespace pcl::indoor
