/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/quantile.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {

/** The length along a direction within which 98 % of the points lie. REQUIRES: a point.
 */
inline float
extentAlong(const Eigen::Vector3f& direction,
            const std::vector<Eigen::Vector3f>& points)
{
  std::vector<float> places;
  places.reserve(points.size());
  for (const auto& point : points)
    places.push_back(point.dot(direction));
  return extentWithoutStrays(places);
}

} // namespace pcl::indoor
