/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "eppf_pair_counter.h"

#include <pcl/exceptions.h>
#include <pcl/features/eppf_denoising.h>
#include <pcl/features/eppf_histogram.h>
#include <pcl/features/surface_places.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl {
namespace indoor {

namespace {

constexpr double place_share = 1.0 / 3.0; // of the histogram, the rest is of pairs

/** \brief Eq. (5.11), and the sum brought to 1, beside the bins of places. */
template <typename Count>
std::vector<float>
weighted(const std::vector<Count>& counts,
         const std::vector<OrientedPoint>& points,
         double scale,
         const EPPFOptions& options)
{
  const auto& place_bins = options.bins.places;
  const bool has_places = options.features.places && place_bins.size() > 0;
  std::vector<double> weights(counts.size());
  const std::size_t stride = counts.size() / options.bins.distance;
  double sum = 0.0;
  double weight = 1.0;
  for (std::size_t bin = 0; bin < counts.size(); ++bin) {
    if (options.weighting && bin % stride == 0)
      weight = std::log(static_cast<double>(bin / stride) / options.bins.distance +
                        options.weighting_constant);
    weights[bin] = weight * static_cast<double>(counts[bin]);
    sum += weights[bin];
  }
  std::vector<float> histogram(options.bins.size(),
                               std::numeric_limits<float>::quiet_NaN());
  if (!(sum > 0.0))
    return histogram;
  const double share = has_places ? 1.0 - place_share : 1.0;
  std::transform(weights.begin(), weights.end(), histogram.begin(), [&](double w) {
    return static_cast<float>(share * w / sum);
  });
  const auto first_place =
      histogram.begin() + static_cast<std::ptrdiff_t>(counts.size());
  std::fill(first_place, histogram.end(), 0.0f);
  if (!has_places)
    return histogram;
  const auto places =
      surfacePlaces(points, scale, place_bins, options.number_of_threads);
  std::transform(places.begin(), places.end(), first_place, [](double place) {
    return static_cast<float>(place_share * place);
  });
  return histogram;
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

/** \brief The histogram of an object whose noise is lowered first. */
std::vector<float>
noisyHistogram(const std::vector<OrientedPoint>& points,
               const std::vector<std::uint32_t>& order,
               float extent,
               const PointNoise& noise,
               const EPPFOptions& options)
{
  const auto object = denoised(points, order, extent, noise, options.number_of_threads);
  auto sampler = options.sampling == PairSampling::Stratified
                     ? PairSampler(object.points.size(), options.seed)
                     : PairSampler(object.points, options.sampling, options.seed);
  const double scale = options.scale > 0.0 ? options.scale : object.extent;
  const PairCounter counter(object.points, std::move(sampler), scale, options);
  const auto counts = countPairs<std::uint64_t>(
      options.pair_count,
      options.bins.pairSize(),
      options.number_of_threads,
      [&](std::size_t first, std::size_t last, auto& own) {
        counter.countSoftly(first, last, object.weights, noise.evidence, own);
      });
  return weighted(counts, object.points, scale, options);
}

} // namespace

std::vector<float>
eppfHistogram(const std::vector<OrientedPoint>& points, const EPPFOptions& options)
{
  const auto problem = whatIsWrong(options);
  if (!problem.empty())
    PCL_THROW_EXCEPTION(BadArgumentException, problem);
  const float extent = objectExtent(points);
  if (!(extent > 0.0f))
    return std::vector<float>(options.bins.size(),
                              std::numeric_limits<float>::quiet_NaN());
  const bool is_stratified = options.sampling == PairSampling::Stratified;
  std::vector<std::uint32_t> order;
  if (options.denoising || is_stratified)
    order = spaceFillingOrder(points);
  if (options.denoising) {
    const auto noise = measureNoise(points, order, extent, options.number_of_threads);
    if (noise.evidence > 0.0f)
      return noisyHistogram(points, order, extent, noise, options);
  }
  const double scale = options.scale > 0.0 ? options.scale : extent;
  auto sampler = is_stratified ? PairSampler(points.size(), options.seed)
                               : PairSampler(points, options.sampling, options.seed);
  std::vector<OrientedPoint> along_order;
  if (is_stratified)
    along_order = arranged(points, order);
  const auto& used = is_stratified ? along_order : points;
  const PairCounter counter(used, std::move(sampler), scale, options);
  const auto counts =
      countPairs(options.pair_count,
                 options.bins.pairSize(),
                 options.number_of_threads,
                 [&counter](std::size_t first, std::size_t last, auto& own) {
                   counter.count(first, last, own);
                 });
  return weighted(counts, used, scale, options);
}

} // namespace indoor
} // namespace pcl
