/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/pair_sampling.h>

#include <algorithm>
#include <cassert>
#include <numeric>

namespace pcl {
namespace indoor {

namespace {

/** \brief Spread the lower ten bits of a number, two zeros between any two. */
std::uint32_t
spreadBits(std::uint32_t value)
{
  value = (value | (value << 16)) & 0x030000FFu;
  value = (value | (value << 8)) & 0x0300F00Fu;
  value = (value | (value << 4)) & 0x030C30C3u;
  return (value | (value << 2)) & 0x09249249u;
}

/** \brief Indices of the points along a Z curve (Morton order) through their cube. */
std::vector<std::uint32_t>
spaceFillingOrder(const std::vector<OrientedPoint>& points)
{
  Eigen::Array3f lower = points.front().position;
  Eigen::Array3f upper = lower;
  for (const auto& point : points) {
    lower = lower.min(point.position.array());
    upper = upper.max(point.position.array());
  }
  const float edge = std::max((upper - lower).maxCoeff(), 1e-30f);
  std::vector<std::uint32_t> codes;
  codes.reserve(points.size());
  for (const auto& point : points) {
    const Eigen::Array3f place = (point.position.array() - lower) * (1023.0f / edge);
    codes.push_back(spreadBits(static_cast<std::uint32_t>(place[0])) << 2 |
                    spreadBits(static_cast<std::uint32_t>(place[1])) << 1 |
                    spreadBits(static_cast<std::uint32_t>(place[2])));
  }
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  // Points of one cell of the curve by their coordinates: no order of the input counts.
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (codes[a] != codes[b])
      return codes[a] < codes[b];
    const auto& one = points[a].position;
    const auto& two = points[b].position;
    return std::lexicographical_compare(
        one.data(), one.data() + 3, two.data(), two.data() + 3);
  });
  return order;
}

} // namespace

PairSampler::PairSampler(const std::vector<OrientedPoint>& points,
                         PairSampling sampling,
                         std::uint32_t seed)
: seed_(hash(seed + 0x9E3779B97F4A7C15u))
, point_count_(points.size())
{
  assert(points.size() >= 2);
  if (sampling == PairSampling::Stratified)
    order_ = spaceFillingOrder(points);
}

} // namespace indoor
} // namespace pcl
