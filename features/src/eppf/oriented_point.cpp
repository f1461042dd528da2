/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/oriented_point.h>

#include "internal/point_bounds.h"

#include <pcl/indoor/usable_point.h>

#include <cmath>

namespace pcl::indoor {

namespace {

/** \brief The point of the set farthest from a place, and its squared distance. */
std::pair<Eigen::Vector3f, float>
farthestFrom(const Eigen::Vector3f& place, const std::vector<OrientedPoint>& points)
{
  std::pair<Eigen::Vector3f, float> farthest{place, 0.0f};
  for (const auto& point : points) {
    const float distance = (point.position - place).squaredNorm();
    if (distance > farthest.second)
      farthest = {point.position, distance};
  }
  return farthest;
}

} // namespace

float
objectExtent(const std::vector<OrientedPoint>& points)
{
  if (points.empty())
    return 0.0f;
  auto end = farthestFrom(centroidOf(points), points).first;
  float extent = 0.0f;
  for (int sweep = 0; sweep < 8; ++sweep) {
    const auto [other_end, distance] = farthestFrom(end, points);
    if (!(distance > extent))
      break;
    extent = distance;
    end = other_end;
  }
  return std::sqrt(extent);
}

bool
isUsableExtent(float extent)
{
  return extent > 0.0f && extent <= 4.0f * largest_coordinate; // of a cube: 2 sqrt(3)
}

} // namespace pcl::indoor
