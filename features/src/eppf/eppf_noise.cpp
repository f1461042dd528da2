/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "eppf/local_planes.h"

#include <pcl/features/eppf_denoising.h>
#include <pcl/features/pair_counting.h>
#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/quantile.h>

#include <array>
#include <cassert>

namespace pcl::indoor {

namespace {

constexpr std::size_t fewest_points = 256;
constexpr int probe_count = 32;        // enough for most objects without noise
constexpr int many_probes_count = 128; // where these leave it open

/** \brief The point at the middle of the probe-th of count equal parts of the order.
 */
std::size_t
probedPoint(const PointColumns& points, int probe, int count)
{
  return (2 * static_cast<std::size_t>(probe) + 1) * points.size() /
         (2 * static_cast<std::size_t>(count));
}

/** \brief Deviation of the points from planes, of one of the flattest probes. */
float
residual(const PointColumns& points, float width, int threads)
{
  std::array<float, probe_count> squares;
  parallelFor(
      probe_count,
      threads,
      2,
      [] { return Nearby(); },
      [&](Nearby& nearby, std::ptrdiff_t number) {
        const int probe = static_cast<int>(number);
        const Eigen::Vector3f place =
            points.at(probedPoint(points, probe, probe_count));
        nearby.gather(points, {place, place, 0, 0}, width);
        const float seen = planeAround(nearby, place, width).variances[0];
        // A window of variance v shows noise of variance s as 1 / (1 / s + 1 / v).
        const float window = width * width;
        squares[probe] =
            seen < 0.999f * window ? seen * window / (window - seen) : 1000.0f * window;
      });
  return std::sqrt(valueAtRank(squares, probe_count / 10));
}

/** \brief Evidence of noise: none if two of a few neighbourhoods are flat. */
float
evidenceOfFew(const PointColumns& points, float spacing)
{
  constexpr float flat = 0.12f;
  std::array<float, probe_count> thickness;
  int flat_count = 0;
  for (int probe = 0; probe < probe_count; ++probe) {
    const std::size_t center = probedPoint(points, probe, probe_count);
    thickness[probe] = planeOfNearest(points, center, 2.6f * spacing).thickness();
    flat_count += thickness[probe] <= flat ? 1 : 0;
    if (flat_count == 2)
      return 0.0f;
  }
  return ramp(valueAtRank(thickness, 1), flat, 0.16f);
}

/** \brief Evidence of noise: none if a tenth of many neighbourhoods is rather flat, as
 * it is on objects of small parts. */
float
evidenceOfMany(const PointColumns& points, float spacing, int threads)
{
  std::array<float, many_probes_count> thickness;
  parallelFor(many_probes_count,
              threads,
              evenChunk(many_probes_count, threads),
              [&](std::ptrdiff_t number) {
                const int probe = static_cast<int>(number);
                thickness[probe] =
                    planeOfNearest(points,
                                   probedPoint(points, probe, many_probes_count),
                                   2.6f * spacing)
                        .thickness();
              });
  return ramp(valueAtRank(thickness, many_probes_count / 10), 0.22f, 0.25f);
}

} // namespace

PointNoise
measureNoise(const std::vector<OrientedPoint>& points,
             const std::vector<std::uint32_t>& order,
             float extent,
             unsigned int number_of_threads)
{
  assert(points.size() == order.size());
  if (points.size() < fewest_points)
    return {};
  const PointColumns some(points, order);
  const float spacing = usualSpacing(some.size(), extent);
  PointNoise noise;
  noise.evidence = evidenceOfFew(some, spacing);
  if (!(noise.evidence > 0.0f))
    return {};
  const int threads = threadCount(number_of_threads);
  noise.evidence *= evidenceOfMany(some, spacing, threads);
  if (!(noise.evidence > 0.0f))
    return {};
  float width = 1.5f * spacing;
  noise.deviation = residual(some, width, threads);
  while (width < 1.4f * noise.deviation && width < extent) {
    width *= 1.25f;
    noise.deviation = residual(some, width, threads);
  }
  // Finer noise may as well be small parts of the object, and harms little.
  noise.evidence *= ramp(noise.deviation / spacing, 0.45f, 0.55f);
  return noise.evidence > 0.0f ? noise : PointNoise();
}

} // namespace pcl::indoor
