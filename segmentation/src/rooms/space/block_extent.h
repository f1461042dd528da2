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

/** \brief Edge of the blocks that find the extent, metres; parts closer than this stay
 * together. */
constexpr double block_size = 1.0;

/** \brief A separate part is kept if it enlarges the box by at most this many blocks
 * per block of its own: a second building is, what glass mirrors is not. Larger keeps
 * more and takes more memory. */
constexpr double most_growth = 500.0;

/** \brief The box of those connected parts of a cloud that are worth their space.
 * REQUIRES: at least one point.
 */
Box
blockExtent(const std::vector<Eigen::Vector3f>& points, int threads);

} // namespace pcl::indoor
