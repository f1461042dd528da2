/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/point_tiles.h>

#include <Eigen/Core>

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
  PointTiles<Eigen::Vector2d> tiles_;
};

} // namespace pcl::indoor
