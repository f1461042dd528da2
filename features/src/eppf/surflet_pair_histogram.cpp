/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/surflet_pair_histogram.h>

#include "eppf/pair_options.h"

#include <pcl/features/pair_counting.h>
#include <pcl/indoor/require_valid.h>

#include <Eigen/Geometry> // for cross

#include <cmath>
#include <limits>
#include <numeric>

namespace pcl::indoor {

namespace {

constexpr float pi = 3.14159265358979f;

/** \brief The bin of a place between 0 and 1. */
std::size_t
binOf(float place, int bin_count)
{
  const int bin = static_cast<int>(place * static_cast<float>(bin_count));
  return static_cast<std::size_t>(std::clamp(bin, 0, bin_count - 1));
}

} // namespace

std::array<float, 4>
surfletPairFeatures(const OrientedPoint& one, const OrientedPoint& two)
{
  const Eigen::Vector3f line = two.position - one.position;
  const bool from_one =
      std::abs(one.normal.dot(line)) <= std::abs(two.normal.dot(line));
  const float distance = line.norm();
  const Eigen::Vector3f direction = (from_one ? line : -line) / distance;
  const Eigen::Vector3f& u = from_one ? one.normal : two.normal;
  const Eigen::Vector3f& other = from_one ? two.normal : one.normal;
  const Eigen::Vector3f across = direction.cross(u);
  const float length = across.norm();
  const float gamma = u.dot(direction);
  if (!(length > 1e-6f)) // the rounding of a cross product of unit vectors
    return {0.0f, 0.0f, gamma, distance};
  const Eigen::Vector3f v = across / length;
  const Eigen::Vector3f w = u.cross(v);
  return {std::atan2(w.dot(other), u.dot(other)), v.dot(other), gamma, distance};
}

std::string
findProblem(const SurfletPairOptions& options)
{
  OptionCheck check;
  check.require(options.bin_count >= 1 && options.bin_count <= 16,
                "number of bins of a feature must be in 1 ... 16",
                options.bin_count);
  checkPairOptions(check, options.pair_count, options.scale);
  return check.problem();
}

std::vector<float>
surfletPairHistogram(const std::vector<OrientedPoint>& points,
                     const SurfletPairOptions& options)
{
  requireValid(options);
  const int n = options.bin_count;
  const auto bin_count = static_cast<std::size_t>(n) * n * n * n;
  const float extent = objectExtent(points);
  if (!isUsableExtent(extent))
    return std::vector<float>(bin_count, std::numeric_limits<float>::quiet_NaN());
  const float scale = options.scale > 0.0 ? static_cast<float>(options.scale) : extent;
  const PairSampler sampler(points, options.sampling, options.seed);
  const auto count_block = [&](std::size_t first, std::size_t last, auto& counts) {
    for (std::size_t k = first; k < last; ++k) {
      const auto [one, two] = sampler.pair(k);
      if (points[one].position == points[two].position)
        continue; // no line between them
      const auto f = surfletPairFeatures(points[one], points[two]);
      const auto alpha = binOf((f[0] + pi) / (2 * pi), n);
      const auto beta = binOf((f[1] + 1) / 2, n);
      const auto gamma = binOf((f[2] + 1) / 2, n);
      const auto delta = binOf(std::min(f[3] / scale, 1.0f), n);
      ++counts[((alpha * n + beta) * n + gamma) * n + delta];
    }
  };
  const auto counts =
      countPairs(options.pair_count, bin_count, options.number_of_threads, count_block);
  const double sum = std::accumulate(counts.begin(), counts.end(), 0.0);
  std::vector<float> histogram(bin_count);
  std::transform(counts.begin(), counts.end(), histogram.begin(), [sum](auto count) {
    return static_cast<float>(count / sum);
  });
  return histogram;
}

} // namespace pcl::indoor
