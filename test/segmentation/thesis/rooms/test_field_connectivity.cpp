/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "thesis/rooms/field_connectivity.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using pcl::indoor::FieldConnectivity;
using pcl::indoor::PixelMap;

namespace {

PixelMap<float>
randomMap(int nx, int ny, unsigned values, std::mt19937& rng)
{
  PixelMap<float> map{nx, ny, {}};
  map.values.resize(map.size());
  for (float& value : map.values)
    value = static_cast<float>(rng() % values);
  return map;
}

/** Components of the pixels that reach a threshold, by flooding; -1 below it. */
std::vector<int>
componentsAt(const PixelMap<float>& map, float threshold)
{
  std::vector<int> label(map.size(), -1);
  for (std::size_t seed = 0; seed < map.size(); ++seed) {
    if (label[seed] >= 0 || map.values[seed] < threshold)
      continue;
    std::vector<std::size_t> stack{seed};
    label[seed] = static_cast<int>(seed);
    while (!stack.empty()) {
      const int x = static_cast<int>(stack.back()) / map.ny;
      const int y = static_cast<int>(stack.back()) % map.ny;
      stack.pop_back();
      for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy) {
          if (!map.contains(x + dx, y + dy))
            continue;
          const std::size_t other = map.index(x + dx, y + dy);
          if (label[other] < 0 && map.values[other] >= threshold) {
            label[other] = static_cast<int>(seed);
            stack.push_back(other);
          }
        }
    }
  }
  return label;
}

/** Eq. (3.3) as the text means it: threshold after threshold, from the highest. */
std::vector<float>
distancesByThresholding(const PixelMap<float>& map, std::vector<float> thresholds)
{
  const float a = *std::max_element(map.values.begin(), map.values.end());
  if (thresholds.empty())
    thresholds = map.values;
  std::sort(thresholds.rbegin(), thresholds.rend());
  const std::size_t n = map.size();
  std::vector<float> distances(n * n, a);
  for (const float threshold : thresholds) {
    if (threshold <= 0.0f)
      continue;
    const auto label = componentsAt(map, threshold);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (label[i] >= 0 && label[i] == label[j])
          distances[i * n + j] = std::min(distances[i * n + j], a - threshold);
  }
  for (std::size_t i = 0; i < n; ++i)
    distances[i * n + i] = 0.0f;
  return distances;
}

void
expectEqualsThresholding(const PixelMap<float>& map,
                         const std::vector<float>& thresholds)
{
  const FieldConnectivity connectivity(map, thresholds);
  const auto expected = distancesByThresholding(map, thresholds);
  for (std::size_t i = 0; i < map.size(); ++i)
    for (std::size_t j = 0; j < map.size(); ++j)
      ASSERT_EQ(connectivity.distance(i, j), expected[i * map.size() + j])
          << "between " << i << " and " << j << " of " << map.nx << " x " << map.ny;
}

} // namespace

TEST(FieldConnectivity, EqualsThresholdingAtEveryValue)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 40; ++trial) {
    const int nx = 1 + rng() % 12, ny = 1 + rng() % 12;
    const auto map = randomMap(nx, ny, 2 + rng() % 30, rng);
    expectEqualsThresholding(map, {});
  }
}

TEST(FieldConnectivity, EqualsThresholdingAtGivenThresholds)
{
  std::mt19937 rng(2);
  for (int trial = 0; trial < 40; ++trial) {
    const auto map = randomMap(1 + rng() % 12, 1 + rng() % 12, 20, rng);
    std::vector<float> thresholds;
    for (unsigned k = rng() % 5 + 1; k > 0; --k)
      thresholds.push_back(static_cast<float>(rng() % 25));
    expectEqualsThresholding(map, thresholds);
  }
}

TEST(FieldConnectivity, QueriesOverManyBlocksEqualThresholding)
{
  std::mt19937 rng(3);
  expectEqualsThresholding(randomMap(1, 700, 9, rng), {});
  auto ramp = randomMap(1, 600, 2, rng);
  for (std::size_t i = 0; i < ramp.size(); ++i)
    ramp.values[i] = static_cast<float>(i + 1);
  expectEqualsThresholding(ramp, {});
}

TEST(FieldConnectivity, IsAnUltrametric)
{
  std::mt19937 rng(4);
  const auto map = randomMap(9, 9, 12, rng);
  const FieldConnectivity c(map);
  for (std::size_t i = 0; i < map.size(); ++i)
    for (std::size_t j = 0; j < map.size(); ++j) {
      EXPECT_EQ(c.distance(i, j), c.distance(j, i));
      for (std::size_t k = 0; k < map.size(); ++k) {
        if (i == j || j == k || i == k)
          continue;
        EXPECT_LE(c.distance(i, j), std::max(c.distance(i, k), c.distance(k, j)));
      }
    }
}

TEST(FieldConnectivity, RejectsWhatIsNoField)
{
  const PixelMap<float> negative{1, 2, {1.0f, -1.0f}};
  EXPECT_THROW(FieldConnectivity{negative}, pcl::BadArgumentException);
  const PixelMap<float> not_a_number{1, 2, {1.0f, std::nanf("")}};
  EXPECT_THROW(FieldConnectivity{not_a_number}, pcl::BadArgumentException);
  const PixelMap<float> short_of_values{2, 2, {1.0f}};
  EXPECT_THROW(FieldConnectivity{short_of_values}, pcl::BadArgumentException);
  const PixelMap<float> good{1, 1, {1.0f}};
  EXPECT_THROW(FieldConnectivity(good, {-1.0f}), pcl::BadArgumentException);
  EXPECT_EQ(FieldConnectivity(PixelMap<float>{}).maximum(), 0.0f);
}

TEST(HistogramPeaks, FindsTheModes)
{
  std::vector<float> values;
  for (int k = 0; k < 50; ++k)
    for (const float mode : {10.0f, 40.0f, 90.0f})
      values.push_back(mode + 0.5f);
  for (int k = 0; k < 10; ++k)
    for (const float mode : {9.0f, 11.0f, 39.0f, 41.0f, 89.0f, 91.0f})
      values.push_back(mode + 0.5f);
  values.push_back(100.0f);
  values.push_back(0.0f);
  const auto peaks = pcl::indoor::histogramPeaks(values, {100, 0, 0.1});
  EXPECT_EQ(peaks, (std::vector<float>{10.0f, 40.0f, 90.0f}));
  // without a demand on prominence the single largest value is a peak too
  EXPECT_EQ(pcl::indoor::histogramPeaks(values, {100, 0, 0.0}).size(), 4u);
  // nine bins of smoothing keep three modes, but put them on plateaus
  EXPECT_EQ(pcl::indoor::histogramPeaks(values, {100, 4, 0.1}).size(), 3u);
}

TEST(HistogramPeaks, APlateauIsOnePeak)
{
  std::vector<float> values{4.0f};
  for (const float v : {1.1f, 1.1f, 2.1f, 2.1f})
    values.push_back(v);
  EXPECT_EQ(pcl::indoor::histogramPeaks(values, {4, 0, 0.6}),
            (std::vector<float>{1.0f}));
}

TEST(HistogramPeaks, HandlesLittleInput)
{
  EXPECT_TRUE(pcl::indoor::histogramPeaks({}, {}).empty());
  EXPECT_TRUE(pcl::indoor::histogramPeaks({0.0f, -3.0f}, {}).empty());
  EXPECT_EQ(pcl::indoor::histogramPeaks({5.0f, 5.0f}, {10, 0, 0.0}).size(), 1u);
  EXPECT_THROW(pcl::indoor::histogramPeaks({1.0f}, {0, 0, 0.0}),
               pcl::BadArgumentException);
  EXPECT_THROW(pcl::indoor::histogramPeaks({1.0f}, {4, -1, 0.0}),
               pcl::BadArgumentException);
  EXPECT_THROW(pcl::indoor::histogramPeaks({1.0f}, {4, 0, std::nan("")}),
               pcl::BadArgumentException);
}
