/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/eppf_denoising.h>

#include "eppf/local_planes.h"

#include <pcl/features/pair_counting.h>
#include <pcl/features/pair_sampling.h>
#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/quantile.h>

#include <cassert>

namespace pcl::indoor {

namespace {

/** \brief The distance that one in a hundred pairs exceeds. */
float
largeDistance(const std::vector<OrientedPoint>& points)
{
  constexpr std::size_t pair_count = 4096;
  const PairSampler sampler(points.size(), 0);
  std::vector<float> distances(pair_count);
  for (std::size_t k = 0; k < pair_count; ++k) {
    const auto pair = sampler.pair(k);
    distances[k] = (points[pair.first].position - points[pair.second].position).norm();
  }
  return valueAtRank(distances, pair_count - pair_count / 100);
}

} // namespace

DenoisedObject
denoised(const std::vector<OrientedPoint>& points,
         const std::vector<std::uint32_t>& order,
         float extent,
         const PointNoise& noise,
         unsigned int number_of_threads)
{
  assert(points.size() == order.size());
  const PointColumns some(points, order);
  const float width = 1.2f * noise.deviation;
  DenoisedObject object;
  object.points.resize(some.size());
  object.weights.resize(some.size());
  const auto block_count = static_cast<int>(some.blocks.size());
  parallelFor(
      block_count,
      threadCount(number_of_threads),
      4,
      [] { return Nearby(); },
      [&](Nearby& nearby, std::ptrdiff_t block) {
        nearby.gather(some, some.blocks[block], width);
        const std::size_t first = some.blocks[block].first;
        const std::size_t last = some.blocks[block].last;
        for (std::size_t k = first; k < last; ++k) {
          const auto plane = planeAround(nearby, some.at(k), width);
          object.points[k] = points[some.indices[k]];
          object.points[k].position +=
              noise.evidence * plane.normal.dot(plane.offset) * plane.normal;
          const float flatness = std::max(1.0f - plane.thickness(), 0.02f);
          object.weights[k] = 1.0f + noise.evidence * (flatness - 1.0f);
        }
      });
  // Noise finer than the points are dense moves the farthest ones but little.
  const float coarseness =
      ramp(noise.deviation / usualSpacing(some.size(), extent), 0.5f, 1.0f);
  const float share = noise.evidence * coarseness;
  object.extent = (1.0f - share) * extent + share * 1.1f * largeDistance(object.points);
  return object;
}

} // namespace pcl::indoor
