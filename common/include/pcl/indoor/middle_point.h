/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/quantile.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief The median of each coordinate: an origin near the points, the same for any
 * order of them and wherever outliers lie. Of none it is zero. */
inline Eigen::Vector3d
middlePoint(const std::vector<Eigen::Vector3f>& points)
{
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  std::vector<float> values(points.size());
  for (int axis = 0; axis < 3 && !points.empty(); ++axis) {
    for (std::size_t i = 0; i < points.size(); ++i)
      values[i] = points[i][axis];
    middle[axis] = median(values);
  }
  return middle;
}

/** \brief Move points so that their middlePoint() is the origin: nothing is lost in
 * large coordinates.
 * \return where the origin was taken from
 */
inline Eigen::Vector3d
moveToMiddle(std::vector<Eigen::Vector3f>& points)
{
  const Eigen::Vector3d origin = middlePoint(points);
  for (auto& point : points)
    point = (point.cast<double>() - origin).cast<float>();
  return origin;
}

} // namespace pcl::indoor
