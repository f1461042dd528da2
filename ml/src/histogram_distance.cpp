/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/histogram_distance.h>

#include <pcl/exceptions.h>
#include <pcl/indoor/threads.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace pcl::indoor {

namespace {

constexpr std::size_t lane_count =
    8; // sums of one distance that the compiler runs side by side

/** \brief Histograms ready for comparison: bins padded with zeros to a multiple of
 * lanes. */
struct Prepared {
  std::vector<std::vector<float>> bins;
  std::vector<std::vector<float>> logarithms; // empty unless wanted
  std::vector<bool> is_finite;
};

Prepared
prepare(const Histograms& histograms,
        std::size_t bin_count,
        bool for_logarithm,
        float floor)
{
  const std::size_t padded = (bin_count + lane_count - 1) / lane_count * lane_count;
  Prepared prepared;
  for (const auto& histogram : histograms) {
    if (histogram.size() != bin_count)
      PCL_THROW_EXCEPTION(BadArgumentException,
                          "A histogram of " << histogram.size()
                                            << " bins cannot be compared with one of "
                                            << bin_count);
    prepared.is_finite.push_back(
        std::all_of(histogram.begin(), histogram.end(), [](float bin) {
          return std::isfinite(bin);
        }));
    prepared.bins.push_back(histogram);
    if (for_logarithm) {
      auto& bins = prepared.bins.back();
      std::replace_if(
          bins.begin(), bins.end(), [](float bin) { return !(bin > 0.0f); }, floor);
      prepared.logarithms.emplace_back(padded);
      std::transform(bins.begin(),
                     bins.end(),
                     prepared.logarithms.back().begin(),
                     [](float bin) { return std::log(bin); });
    }
    prepared.bins.back().resize(padded);
  }
  return prepared;
}

/** \brief Sum of a term over all bins; the order of the additions is fixed. */
template <typename Term>
float
sumOver(std::size_t padded, const Term& term)
{
  float sums[lane_count] = {};
  for (std::size_t first = 0; first < padded; first += lane_count)
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      sums[lane] += term(first + lane);
  return ((sums[0] + sums[4]) + (sums[1] + sums[5])) +
         ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

float
distanceBetween(const Prepared& queries,
                std::size_t query,
                const Prepared& gallery,
                std::size_t other,
                HistogramDistance distance)
{
  const float* const a = queries.bins[query].data();
  const float* const b = gallery.bins[other].data();
  const std::size_t size = queries.bins[query].size();
  switch (distance) {
  case HistogramDistance::SymmetricKullbackLeibler: {
    const float* const ln_a = queries.logarithms[query].data();
    const float* const ln_b = gallery.logarithms[other].data();
    return sumOver(size,
                   [=](std::size_t k) { return (a[k] - b[k]) * (ln_a[k] - ln_b[k]); });
  }
  case HistogramDistance::L1:
    return sumOver(size, [=](std::size_t k) { return std::abs(a[k] - b[k]); });
  case HistogramDistance::L2:
    return std::sqrt(
        sumOver(size, [=](std::size_t k) { return (a[k] - b[k]) * (a[k] - b[k]); }));
  case HistogramDistance::ChiSquared:
    break;
  }
  constexpr float tiny = std::numeric_limits<float>::min(); // 0 / tiny is 0
  return sumOver(size, [=](std::size_t k) {
    return (a[k] - b[k]) * (a[k] - b[k]) / std::max(a[k] + b[k], tiny);
  });
}

} // namespace

float
emptyBinValue(const Histograms& histograms)
{
  float smallest = std::numeric_limits<float>::infinity();
  for (const auto& histogram : histograms)
    for (const float bin : histogram)
      if (bin > 0.0f && bin < smallest)
        smallest = bin;
  return std::isfinite(smallest)
             ? std::max(smallest / 2, std::numeric_limits<float>::min())
             : std::numeric_limits<float>::min();
}

DistanceTable
histogramDistances(const Histograms& queries,
                   const Histograms& gallery,
                   HistogramDistance distance,
                   unsigned int number_of_threads)
{
  DistanceTable table{queries.size(), gallery.size(), {}};
  table.values.resize(table.rows * table.columns,
                      std::numeric_limits<float>::infinity());
  if (table.values.empty())
    return table;
  const bool for_logarithm = distance == HistogramDistance::SymmetricKullbackLeibler;
  const float floor = std::min(emptyBinValue(queries), emptyBinValue(gallery));
  const std::size_t bin_count = queries.front().size();
  const auto rows = prepare(queries, bin_count, for_logarithm, floor);
  const auto columns = prepare(gallery, bin_count, for_logarithm, floor);
  const int threads = threadCount(number_of_threads);
#pragma omp parallel for schedule(dynamic, 8) num_threads(threads)
  for (std::int64_t row = 0; row < static_cast<std::int64_t>(table.rows); ++row) {
    const auto query = static_cast<std::size_t>(row);
    if (!rows.is_finite[query])
      continue;
    for (std::size_t other = 0; other < table.columns; ++other)
      if (columns.is_finite[other])
        table.values[query * table.columns + other] =
            distanceBetween(rows, query, columns, other, distance);
  }
  return table;
}

} // namespace pcl::indoor
