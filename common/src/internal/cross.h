/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

namespace pcl::indoor {

/** \brief The z of the cross product of two vectors of the plane: positive if the
 * second points to the left of the first. */
inline double
crossOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

} // namespace pcl::indoor
