/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief Turns points by -yaw about z: into a frame whose x axis points along yaw. */
class Turn {
public:
  explicit Turn(double yaw)
  : cosine_(std::cos(yaw))
  , sine_(std::sin(yaw))
  {}

  template <typename Vector>
  Eigen::Vector3d
  operator()(const Vector& point) const
  {
    const double x = point.x();
    const double y = point.y();
    return {cosine_ * x + sine_ * y, cosine_ * y - sine_ * x, point.z()};
  }

private:
  double cosine_;
  double sine_;
};

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

  bool
  contains(const Eigen::Vector3d& p) const
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
            const Turn& turn,
            const BlockExtentOptions& options);

} // namespace indoor
} // namespace pcl
