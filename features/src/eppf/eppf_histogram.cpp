/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/eppf_histogram.h>

#include "eppf/eppf_pair_counter.h"
#include "eppf/harmonic_sums.h"

#include <pcl/features/eppf_denoising.h>
#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/require_valid.h>
#include <pcl/indoor/threads.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pcl::indoor {

namespace {

constexpr double harmonic_share = 0.5; // of the histogram, the rest is of pairs

bool
hasHarmonics(const EPPFOptions& options)
{
  return options.features.harmonics && options.bins.harmonics.size() > 0;
}

/** \brief Eq. (5.11), and the sum brought to 1, or less beside harmonics. */
std::vector<float>
weighted(const std::vector<std::uint64_t>& counts, const EPPFOptions& options)
{
  const std::size_t pair_size = options.bins.pairSize();
  std::vector<double> weights(pair_size);
  const std::size_t stride = pair_size / options.bins.distance;
  double sum = 0.0;
  double weight = 1.0;
  for (std::size_t bin = 0; bin < pair_size; ++bin) {
    if (options.weighting && bin % stride == 0)
      weight = std::log(static_cast<double>(bin / stride) / options.bins.distance +
                        options.weighting_constant);
    weights[bin] = weight * static_cast<double>(counts[bin]);
    sum += weights[bin];
  }
  std::vector<float> histogram(counts.size(), std::numeric_limits<float>::quiet_NaN());
  if (!(sum > 0.0))
    return histogram;
  const double share = hasHarmonics(options) ? 1.0 - harmonic_share : 1.0;
  const auto rest =
      std::transform(weights.begin(), weights.end(), histogram.begin(), [&](double w) {
        return static_cast<float>(share * w / sum);
      });
  std::fill(rest, histogram.end(), 0.0f);
  return histogram;
}

/** \brief The histogram, of blocks of pairs and of blocks of points of a surface. */
template <typename CountPairs>
std::vector<float>
histogramOf(const std::vector<OrientedPoint>& surface,
            const PrincipalFrame& frame,
            double scale,
            const EPPFOptions& options,
            const CountPairs& count_pairs)
{
  const auto& bins = options.bins;
  const std::size_t pair_blocks = blockCount(options.pair_count, pair_block_size);
  constexpr std::size_t block_size = HarmonicSums::block_size;
  const std::size_t surface_blocks =
      hasHarmonics(options) ? blockCount(surface.size(), block_size) : 0;
  const HarmonicSums harmonics(frame, scale, bins.harmonics);
  const auto count = [&](std::size_t block, std::vector<std::uint64_t>& own) {
    if (block < pair_blocks) {
      const auto [first, last] = blockRange(block, options.pair_count, pair_block_size);
      count_pairs(first, last, own);
    }
    else {
      const auto [first, last] =
          blockRange(block - pair_blocks, surface.size(), block_size);
      harmonics.add(surface, first, last, own.data() + bins.pairSize());
    }
  };
  const auto counts = countBlocks(
      pair_blocks + surface_blocks, bins.size(), options.number_of_threads, count);
  auto histogram = weighted(counts, options);
  if (hasHarmonics(options) && std::isfinite(histogram.front())) {
    const auto values =
        harmonics.values(counts.data() + bins.pairSize(), surface.size());
    std::transform(values.begin(),
                   values.end(),
                   histogram.end() - static_cast<std::ptrdiff_t>(values.size()),
                   [](double v) { return static_cast<float>(harmonic_share * v); });
  }
  return histogram;
}

/** \brief The frame of harmonics. Where the farthest points are a matter of noise,
 * their middle is no better than the mean of all. */
PrincipalFrame
frameOf(const std::vector<OrientedPoint>& surface,
        float evidence,
        const EPPFOptions& options)
{
  if (!hasHarmonics(options))
    return {Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity()};
  return principalFrame(surface, 0.5 * (1.0 - static_cast<double>(evidence)));
}

/** \brief The points in an order, which spares a look-up per pair. */
std::vector<OrientedPoint>
arranged(const std::vector<OrientedPoint>& points,
         const std::vector<std::uint32_t>& order)
{
  std::vector<OrientedPoint> result(order.size());
  std::transform(order.begin(), order.end(), result.begin(), [&](std::uint32_t index) {
    return points[index];
  });
  return result;
}

/** \brief The sampler of points that are arranged if that is what stratified pairs
 * want. */
PairSampler
samplerOf(const std::vector<OrientedPoint>& points, const EPPFOptions& options)
{
  return options.sampling == PairSampling::Stratified
             ? PairSampler(points.size(), options.seed)
             : PairSampler(points, options.sampling, options.seed);
}

/** \brief The histogram of an object whose noise is lowered first. */
std::vector<float>
noisyHistogram(const std::vector<OrientedPoint>& points,
               const std::vector<std::uint32_t>& order,
               float extent,
               const PointNoise& noise,
               const EPPFOptions& options)
{
  const auto object = denoised(points, order, extent, noise, options.number_of_threads);
  const double scale = options.scale > 0.0 ? options.scale : object.extent;
  const PairCounter counter(
      object.points, samplerOf(object.points, options), scale, options);
  // Harmonics are smooth already: of points where they are, not moved to planes.
  return histogramOf(points,
                     frameOf(points, noise.evidence, options),
                     scale,
                     options,
                     [&](std::size_t first, std::size_t last, auto& own) {
                       counter.addInterpolated(
                           first, last, object.weights, noise.evidence, own);
                     });
}

} // namespace

std::vector<float>
eppfHistogram(const std::vector<OrientedPoint>& points, const EPPFOptions& options)
{
  requireValid(options);
  const bool is_stratified = options.sampling == PairSampling::Stratified;
  const int threads = std::min(threadCount(options.number_of_threads), 2);
  std::vector<std::uint32_t> order;
  float extent = 0.0f;
  parallelFor(2, threads, 1, [&](std::ptrdiff_t task) {
    if (task == 1)
      extent = objectExtent(points);
    else if (options.denoising || is_stratified)
      order = spaceFillingOrder(points);
  });
  if (!isUsableExtent(extent))
    return std::vector<float>(options.bins.size(),
                              std::numeric_limits<float>::quiet_NaN());
  if (options.denoising) {
    const auto noise = measureNoise(points, order, extent, options.number_of_threads);
    if (noise.evidence > 0.0f)
      return noisyHistogram(points, order, extent, noise, options);
  }
  const double scale = options.scale > 0.0 ? options.scale : extent;
  std::vector<OrientedPoint> along_order;
  if (is_stratified)
    along_order = arranged(points, order);
  const auto& used = is_stratified ? along_order : points;
  std::optional<PairCounter> counter;
  PrincipalFrame frame;
  parallelFor(2, threads, 1, [&](std::ptrdiff_t task) {
    if (task == 1)
      frame = frameOf(used, 0.0f, options);
    else
      counter.emplace(used, samplerOf(used, options), scale, options);
  });
  return histogramOf(
      used, frame, scale, options, [&](std::size_t first, std::size_t last, auto& own) {
        counter->count(first, last, own);
      });
}

} // namespace pcl::indoor
