/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <Eigen/Core>

namespace pcl::indoor {

inline double
crossProduct(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** \brief Where two lines meet that are not parallel: each is a point and a direction.
 */
inline Eigen::Vector2d
lineMeeting(const Eigen::Vector2d& a,
            const Eigen::Vector2d& along_a,
            const Eigen::Vector2d& b,
            const Eigen::Vector2d& along_b)
{
  return a + crossProduct(b - a, along_b) / crossProduct(along_a, along_b) * along_a;
}

} // namespace pcl::indoor
