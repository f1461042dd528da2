/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/indoor/stray_points.h>

#include "internal/point_bounds.h"

#include <pcl/indoor/middle_point.h>
#include <pcl/indoor/quantile.h>

#include <algorithm>

namespace {

constexpr double median_distances = 100; // a stray is farther than so many

} // namespace

namespace pcl::indoor {

std::vector<std::size_t>
strayPoints(const std::vector<Eigen::Vector3f>& points)
{
  if (points.empty())
    return {};
  if ((boundsOf(points).cast<double>().sizes().array() <= float_reach).all())
    return {};
  const Eigen::Vector3d middle = middlePoint(points);
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const auto& point : points)
    distances.push_back((point.cast<double>() - middle).cwiseAbs().maxCoeff());
  auto sorted = distances;
  const double farthest = std::max(float_reach, median_distances * median(sorted));
  std::vector<std::size_t> strays;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (distances[i] > farthest)
      strays.push_back(i);
  return strays;
}

} // namespace pcl::indoor
