/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
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
  const auto at = [&places](std::size_t rank) {
    const auto place = places.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(places.begin(), place, places.end());
    return *place;
  };
  const std::size_t strays = places.size() / 100; // at each end
  return at(places.size() - 1 - strays) - at(strays);
}

} // namespace pcl::indoor
