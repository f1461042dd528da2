/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/pair_sampling.h>

#include "internal/point_bounds.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <numeric>

namespace pcl::indoor {

namespace {

/** \brief Spread the lower ten bits of a number, two zeros between any two. */
constexpr std::uint32_t
spreadBits(std::uint32_t value)
{
  value = (value | (value << 16)) & 0x030000FFu;
  value = (value | (value << 8)) & 0x0300F00Fu;
  value = (value | (value << 4)) & 0x030C30C3u;
  return (value | (value << 2)) & 0x09249249u;
}

/** \brief spreadBits() of all numbers of ten bits, which takes half the time. */
constexpr std::array<std::uint32_t, 1024>
spreadNumbers()
{
  std::array<std::uint32_t, 1024> spread{};
  for (std::uint32_t value = 0; value < 1024; ++value)
    spread[value] = spreadBits(value);
  return spread;
}

constexpr auto spread_bits = spreadNumbers();

/** \brief A point and its place on the curve. */
struct Coded {
  std::uint32_t code; // 30 bits
  std::uint32_t index;
};

/** \brief Sort by code, in three passes of ten bits: a comparing sort takes as long as
 * 2,000 pairs. */
void
sortByCode(std::vector<Coded>& order)
{
  std::vector<Coded> sorted(order.size());
  std::array<std::array<std::uint32_t, 1025>, 3> starts{};
  for (const auto& one : order)
    for (unsigned int pass = 0; pass < 3; ++pass)
      ++starts[pass][((one.code >> 10 * pass) & 1023u) + 1];
  for (unsigned int pass = 0; pass < 3; ++pass) {
    std::partial_sum(starts[pass].begin(), starts[pass].end(), starts[pass].begin());
    for (const auto& one : order)
      sorted[starts[pass][(one.code >> 10 * pass) & 1023u]++] = one;
    order.swap(sorted);
  }
}

} // namespace

std::vector<std::uint32_t>
spaceFillingOrder(const std::vector<OrientedPoint>& points)
{
  if (points.empty())
    return {};
  const auto bounds = boundsOf(points);
  const Eigen::Array3f lower = bounds.min();
  constexpr float largest =
      std::numeric_limits<float>::max(); // differences may exceed it
  const float edge = std::clamp(bounds.sizes().maxCoeff(), 1e-30f, largest);
  const float scale = 1023.0f / edge;
  std::vector<Coded> order(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Eigen::Array3f place =
        ((points[k].position.array() - lower) * scale).min(1023.0f);
    order[k] = {spread_bits[static_cast<std::size_t>(place[0])] << 2 |
                    spread_bits[static_cast<std::size_t>(place[1])] << 1 |
                    spread_bits[static_cast<std::size_t>(place[2])],
                static_cast<std::uint32_t>(k)};
  }
  sortByCode(order);
  // Points of one cell of the curve by their coordinates: no order of the input counts.
  const auto isBefore = [&](const Coded& a, const Coded& b) {
    const auto& one = points[a.index].position;
    const auto& two = points[b.index].position;
    return std::lexicographical_compare(
        one.data(), one.data() + 3, two.data(), two.data() + 3);
  };
  for (auto first = order.begin(); first != order.end();) {
    auto last = first + 1;
    while (last != order.end() && last->code == first->code)
      ++last;
    if (last - first > 1)
      std::sort(first, last, isBefore);
    first = last;
  }
  std::vector<std::uint32_t> indices(order.size());
  std::transform(order.begin(), order.end(), indices.begin(), [](const Coded& one) {
    return one.index;
  });
  return indices;
}

PairSampler::PairSampler(const std::vector<OrientedPoint>& points,
                         PairSampling sampling,
                         std::uint32_t seed)
: seed_(hash(seed + 0x9E3779B97F4A7C15u))
, point_count_(points.size())
, is_stratified_(sampling == PairSampling::Stratified)
{
  assert(points.size() >= 2);
  if (is_stratified_)
    order_ = spaceFillingOrder(points);
}

PairSampler::PairSampler(std::size_t point_count, std::uint32_t seed)
: seed_(hash(seed + 0x9E3779B97F4A7C15u))
, point_count_(point_count)
, is_stratified_(true)
{
  assert(point_count_ >= 2);
}

} // namespace pcl::indoor
