/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/quantile.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief A convex body as a discrete oriented polytope: its support, how far it
 * reaches, in each of some fixed directions, metres. */
template <std::size_t Count>
using KDop = std::array<float, Count>;

/** \brief Measure how far places reach; the farthest one in a hundred is left out.
 * \param[in] places at least one, metres
 * \param[in] margin added to each support, metres
 * \param[in] height_along gives, for the number of a direction, a function that tells
 * how far a place lies along it
 */
template <std::size_t Count, typename HeightAlong>
KDop<Count>
supportsOf(const std::vector<Eigen::Vector3f>& places,
           float margin,
           const HeightAlong& height_along)
{
  KDop<Count> supports;
  std::vector<float> heights(places.size());
  const auto outliers = places.size() / 100;
  for (std::size_t d = 0; d < Count; ++d) {
    std::transform(places.begin(), places.end(), heights.begin(), height_along(d));
    supports[d] = valueAtRank(heights, heights.size() - 1 - outliers) + margin;
  }
  return supports;
}

/** \brief Get the hull of two sets of places. */
template <std::size_t Count>
KDop<Count>
hullOfBoth(const KDop<Count>& a, const KDop<Count>& b)
{
  KDop<Count> both;
  std::transform(a.begin(), a.end(), b.begin(), both.begin(), [](float x, float y) {
    return std::max(x, y);
  });
  return both;
}

/** \brief Get what two hulls have in common; its supports may be too large. */
template <std::size_t Count>
KDop<Count>
commonHull(const KDop<Count>& a, const KDop<Count>& b)
{
  KDop<Count> common;
  std::transform(a.begin(), a.end(), b.begin(), common.begin(), [](float x, float y) {
    return std::min(x, y);
  });
  return common;
}

} // namespace pcl::indoor
