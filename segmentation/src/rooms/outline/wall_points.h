/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Points of walls seen from above, found by the line they lie along. */
class WallPoints {
public:
  WallPoints() = default;

  /** \param[in] points finite, pixels */
  WallPoints(const std::vector<Eigen::Vector2d>& points);

  /** \brief Get the points near a line: at least all that are no farther than the
   * margin from it, others not much farther.
   * \param[out] found in no particular order
   */
  void
  alongLine(const Eigen::Vector2d& a,
            const Eigen::Vector2d& b,
            double margin,
            std::vector<Eigen::Vector2d>& found) const;

private:
  /** The tile at a place, clamped to those there are. */
  Eigen::Array2i
  tileAt(const Eigen::Array2d& place) const;

  std::vector<Eigen::Vector2d> points_; ///< tile by tile
  std::vector<std::uint32_t> first_;    ///< per tile, and their end
  Eigen::Array2d low_ = Eigen::Array2d::Zero();
  Eigen::Array2i tiles_ = Eigen::Array2i::Zero(); ///< along x and y; y runs fastest
  double tile_size_ = 1.0;                        ///< pixels
};

} // namespace pcl::indoor
