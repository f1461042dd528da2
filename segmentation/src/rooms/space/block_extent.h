/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace pcl::indoor {

/** \brief An axis-aligned box that holds its borders. */
struct Box {
  Eigen::Vector3d low =
      Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high =
      Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());

  bool
  valid() const
  {
    return low.x() <= high.x();
  }

  void
  add(const Eigen::Vector3d& point)
  {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }

  template <typename Vector>
  bool
  contains(const Vector& p) const
  {
    return p.x() >= low.x() && p.x() <= high.x() && p.y() >= low.y() &&
           p.y() <= high.y() && p.z() >= low.z() && p.z() <= high.z();
  }
};

struct BlockExtentOptions {
  double block_size;  ///< metres
  double max_growth;  ///< blocks of box per block of a part
  double min_density; ///< share of the median block's points
  int threads;
};

/** \brief The box of those connected parts of a cloud that are worth their space.
 * See OccupancyGridOptions. REQUIRES: at least one point, valid options.
 */
Box
blockExtent(const std::vector<Eigen::Vector3f>& points,
            const BlockExtentOptions& options);

} // namespace pcl::indoor
