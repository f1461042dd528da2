/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Geometry> // for AlignedBox3f

namespace pcl::indoor {

/** \brief The position of a point; points that have more to them have an overload. */
inline const Eigen::Vector3f&
positionOf(const Eigen::Vector3f& point)
{
  return point;
}

/** \brief The smallest box around points, at least one. */
template <typename Points>
Eigen::AlignedBox3f
boundsOf(const Points& points)
{
  Eigen::AlignedBox3f box(positionOf(points.front()));
  for (const auto& point : points)
    box.extend(positionOf(point));
  return box;
}

/** \brief The mean position of points, at least one. */
template <typename Points>
Eigen::Vector3f
centroidOf(const Points& points)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& point : points)
    sum += positionOf(point).template cast<double>();
  return (sum / static_cast<double>(points.size())).template cast<float>();
}

} // namespace pcl::indoor
