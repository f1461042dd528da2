/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/upright_profile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::indoor {

namespace {

constexpr std::array<float, 17> heights = {0.1f,
                                           0.2f,
                                           0.3f,
                                           0.4f,
                                           0.5f,
                                           0.6f,
                                           0.7f,
                                           0.8f,
                                           0.9f,
                                           1.0f,
                                           1.2f,
                                           1.4f,
                                           1.6f,
                                           1.8f,
                                           2.0f,
                                           2.3f,
                                           2.7f};
constexpr std::size_t height_bins = heights.size() + 1;
constexpr std::size_t layer_bins = 8;
constexpr std::size_t ring_bins = 6;
constexpr std::size_t coarse_bins = 4; // of layers and rings together
constexpr float level_cosine = 0.8f;

static_assert(2 * (height_bins + layer_bins + ring_bins) + coarse_bins * coarse_bins ==
              upright_profile_size);

/** \brief The bin of a share of 0 ... 1. */
std::size_t
binOf(float share, std::size_t count)
{
  return std::min(static_cast<std::size_t>(share * static_cast<float>(count)),
                  count - 1);
}

/** \brief Height, extent and axis of an object. */
struct UprightExtent {
  explicit UprightExtent(const std::vector<OrientedPoint>& points)
  {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    float highest = -std::numeric_limits<float>::infinity();
    for (const auto& point : points) {
      lowest = std::min(lowest, point.position.z());
      highest = std::max(highest, point.position.z());
      sum += point.position.head<2>().cast<double>();
    }
    axis = (sum / static_cast<double>(points.size())).cast<float>();
    for (const auto& point : points)
      radius = std::max(radius, (point.position.head<2>() - axis).norm());
    height = highest - lowest;
  }

  float lowest = std::numeric_limits<float>::infinity();
  float height = 0.0f;
  float radius = 0.0f;
  Eigen::Vector2f axis = Eigen::Vector2f::Zero();
};

float
share(float part, float whole)
{
  return whole > 0.0f ? part / whole : 0.0f;
}

} // namespace

std::vector<float>
uprightProfile(const std::vector<OrientedPoint>& points, float floor_distance)
{
  std::vector<float> values(upright_profile_size, 0.0f);
  if (points.empty())
    return values;
  const UprightExtent extent(points);
  const float weight = 1.0f / static_cast<float>(points.size());
  for (const auto& [position, normal] : points) {
    const float above_lowest = position.z() - extent.lowest;
    const float layer = share(above_lowest, extent.height);
    const float ring = share((position.head<2>() - extent.axis).norm(), extent.radius);
    const auto height =
        std::upper_bound(heights.begin(), heights.end(), floor_distance + above_lowest);
    const std::size_t other = std::abs(normal.z()) > level_cosine ? 0 : 1;
    std::size_t first = 0;
    const auto count = [&](std::size_t bins, std::size_t bin) {
      values[first + other * bins + bin] += weight;
      first += 2 * bins;
    };
    count(height_bins, static_cast<std::size_t>(height - heights.begin()));
    count(layer_bins, binOf(layer, layer_bins));
    count(ring_bins, binOf(ring, ring_bins));
    values[first + coarse_bins * binOf(layer, coarse_bins) +
           binOf(ring, coarse_bins)] += weight;
  }
  return values;
}

} // namespace pcl::indoor
