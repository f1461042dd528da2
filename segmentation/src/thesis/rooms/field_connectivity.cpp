/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "thesis/rooms/field_connectivity.h"

#include "rooms/space/map_regions.h"

#include <pcl/indoor/disjoint_sets.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace pcl::indoor {
namespace {

constexpr std::size_t block_edge = 16; // gaps per block of the range minima

void
requireUsable(const std::vector<float>& values, const char* what)
{
  for (const float value : values)
    if (!(value >= 0.0f) || !std::isfinite(value))
      PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                          what << " must be finite and not negative, not " << value
                               << ".");
}

/** The highest threshold that a value reaches, 0 if none. */
float
reachedThreshold(float value, const std::vector<float>& ascending)
{
  const auto above = std::upper_bound(ascending.begin(), ascending.end(), value);
  return above == ascending.begin() ? 0.0f : *(above - 1);
}

/** Pixels of positive level, highest first; equal ones by their place. */
std::vector<int>
descendingPixels(const std::vector<float>& level)
{
  std::vector<int> order;
  order.reserve(level.size());
  for (std::size_t i = 0; i < level.size(); ++i)
    if (level[i] > 0.0f)
      order.push_back(static_cast<int>(i));
  std::stable_sort(
      order.begin(), order.end(), [&](int a, int b) { return level[a] > level[b]; });
  return order;
}

} // namespace

FieldConnectivity::FieldConnectivity(const PixelMap<float>& field,
                                     std::vector<float> thresholds)
{
  if (field.values.size() != field.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The map has " << field.values.size() << " values for "
                                       << field.size() << " pixels.");
  requireUsable(field.values, "A value of the field");
  requireUsable(thresholds, "A threshold");
  own_level_ = field.values;
  for (const float value : field.values)
    maximum_ = std::max(maximum_, value);
  if (!thresholds.empty()) {
    std::sort(thresholds.begin(), thresholds.end());
    for (float& value : own_level_)
      value = reachedThreshold(value, thresholds);
  }
  linkPixels(field);
  buildRangeMinima();
}

// Kruskal's algorithm on the pixels, highest first. A component is a chain of pixels;
// two that meet are joined end to end, and the level of the meeting is kept at the
// joint.
void
FieldConnectivity::linkPixels(const PixelMap<float>& field)
{
  const std::size_t count = field.size();
  std::vector<int> next(count, -1), head(count), tail(count);
  std::vector<float> joint(count, 0.0f); // level between a pixel and its next
  std::iota(head.begin(), head.end(), 0);
  std::iota(tail.begin(), tail.end(), 0);
  DisjointSets components(count);
  std::vector<char> present(count, 0);
  const auto connect = [&](std::uint32_t pixel, std::uint32_t neighbour) {
    const std::uint32_t a = components.find(pixel), b = components.find(neighbour);
    if (a == b)
      return;
    next[tail[a]] = head[b];
    joint[tail[a]] = own_level_[pixel];
    const int first = head[a], last = tail[b];
    const std::uint32_t root = components.merge(a, b);
    head[root] = first;
    tail[root] = last;
  };
  for (const int pixel : descendingPixels(own_level_)) {
    present[pixel] = 1;
    forEachNeighbour(field, pixel, Neighbours::Eight, [&](std::size_t other) {
      if (present[other])
        connect(static_cast<std::uint32_t>(pixel), static_cast<std::uint32_t>(other));
    });
  }
  position_.resize(count);
  gaps_.clear();
  gaps_.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (components.find(i) != i)
      continue;
    for (int pixel = head[i]; pixel >= 0; pixel = next[pixel]) {
      position_[pixel] = static_cast<int>(gaps_.size());
      gaps_.push_back(joint[pixel]); // 0 at the end of a component
    }
  }
}

void
FieldConnectivity::buildRangeMinima()
{
  std::vector<float> level((gaps_.size() + block_edge - 1) / block_edge);
  for (std::size_t b = 0; b < level.size(); ++b)
    level[b] = *std::min_element(
        gaps_.begin() + static_cast<std::ptrdiff_t>(b * block_edge),
        gaps_.begin() +
            static_cast<std::ptrdiff_t>(std::min((b + 1) * block_edge, gaps_.size())));
  for (std::size_t width = 1; !level.empty(); width *= 2) {
    block_minima_.push_back(level);
    if (level.size() <= width)
      break;
    std::vector<float> wider(level.size() - width);
    for (std::size_t b = 0; b < wider.size(); ++b)
      wider[b] = std::min(level[b], level[b + width]);
    level = std::move(wider);
  }
}

float
FieldConnectivity::smallestGap(std::size_t first, std::size_t last) const
{
  const std::size_t first_block = first / block_edge, last_block = last / block_edge;
  const auto scan = [this](std::size_t from, std::size_t to, float smallest) {
    for (std::size_t i = from; i <= to; ++i)
      smallest = std::min(smallest, gaps_[i]);
    return smallest;
  };
  if (first_block == last_block)
    return scan(first, last, gaps_[first]);
  float smallest = scan(first, (first_block + 1) * block_edge - 1, gaps_[first]);
  smallest = scan(last_block * block_edge, last, smallest);
  const std::size_t blocks = last_block - first_block - 1; // whole ones between
  if (blocks == 0)
    return smallest;
  std::size_t layer = 0;
  while ((std::size_t{2} << layer) <= blocks)
    ++layer;
  const auto& minima = block_minima_[layer];
  return std::min({smallest,
                   minima[first_block + 1],
                   minima[last_block - (std::size_t{1} << layer)]});
}

namespace {

std::vector<double>
smoothedHistogram(const std::vector<float>& values,
                  float largest,
                  const thesis::HistogramPeakOptions& options)
{
  std::vector<double> counts(static_cast<std::size_t>(options.bins), 0.0);
  for (const float value : values)
    if (value > 0.0f) {
      const auto bin = static_cast<int>(static_cast<double>(value) / largest *
                                        static_cast<double>(options.bins));
      counts[static_cast<std::size_t>(std::min(bin, options.bins - 1))] += 1.0;
    }
  std::vector<double> smooth(counts.size());
  for (int b = 0; b < options.bins; ++b) {
    double sum = 0.0;
    for (int k = b - options.smoothing; k <= b + options.smoothing; ++k)
      if (k >= 0 && k < options.bins)
        sum += counts[static_cast<std::size_t>(k)];
    smooth[static_cast<std::size_t>(b)] = sum / (2 * options.smoothing + 1);
  }
  return smooth;
}

/** The fall from a peak before the histogram rises above it, the smaller of both sides.
 * The histogram counts as 0 beyond its ends.
 */
double
peakProminence(const std::vector<double>& counts, std::size_t peak)
{
  double left = counts[peak], right = counts[peak];
  std::size_t b = peak;
  while (b > 0 && counts[b - 1] <= counts[peak])
    left = std::min(left, counts[--b]);
  if (b == 0)
    left = 0.0;
  b = peak;
  while (b + 1 < counts.size() && counts[b + 1] <= counts[peak])
    right = std::min(right, counts[++b]);
  if (b + 1 == counts.size())
    right = 0.0;
  return counts[peak] - std::max(left, right);
}

} // namespace

std::vector<float>
histogramPeaks(const std::vector<float>& values,
               const thesis::HistogramPeakOptions& options)
{
  if (options.bins < 1 || options.smoothing < 0 || !(options.prominence >= 0.0))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Bad options of the histogram: "
                            << options.bins << " bins, smoothing " << options.smoothing
                            << ", prominence " << options.prominence << ".");
  float largest = 0.0f;
  for (const float value : values)
    if (std::isfinite(value))
      largest = std::max(largest, value);
  if (!(largest > 0.0f))
    return {};
  const std::vector<double> counts = smoothedHistogram(values, largest, options);
  const double fullest = *std::max_element(counts.begin(), counts.end());
  std::vector<float> peaks;
  for (std::size_t b = 0; b < counts.size(); ++b) {
    if (b > 0 && counts[b - 1] >= counts[b])
      continue; // not risen to, or not the first bin of a plateau
    std::size_t end = b + 1;
    while (end < counts.size() && counts[end] == counts[b])
      ++end;
    if (end < counts.size() && counts[end] > counts[b])
      continue;
    if (counts[b] > 0.0 && peakProminence(counts, b) >= options.prominence * fullest)
      peaks.push_back(largest * static_cast<float>(b) /
                      static_cast<float>(counts.size()));
  }
  return peaks;
}

} // namespace pcl::indoor
