/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/persistent_basins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>

using pcl::indoor::persistentBasins;
using pcl::indoor::PixelMap;
using RegionLabels = std::vector<std::int32_t>;

namespace {

/** Numbers 1 ... n in the order of the first pixels; 0 stays. */
RegionLabels
numbered(const RegionLabels& labels)
{
  std::map<std::int32_t, std::int32_t> names{{0, 0}};
  RegionLabels result;
  for (const auto label : labels)
    result.push_back(
        names.emplace(label, static_cast<std::int32_t>(names.size())).first->second);
  return result;
}

std::set<std::int32_t>
labelsAround(const PixelMap<std::int32_t>& labels, std::size_t pixel)
{
  const int x = static_cast<int>(pixel) / labels.ny;
  const int y = static_cast<int>(pixel) % labels.ny;
  std::set<std::int32_t> around;
  for (int u = x - 1; u <= x + 1; ++u)
    for (int v = y - 1; v <= y + 1; ++v)
      if (labels.contains(u, v) && labels.at(u, v) != 0)
        around.insert(labels.at(u, v));
  return around;
}

/** The label of the highest pixel around one that has a label. */
std::int32_t
labelUphill(const PixelMap<float>& field,
            const PixelMap<std::int32_t>& labels,
            std::size_t pixel)
{
  const int x = static_cast<int>(pixel) / labels.ny;
  const int y = static_cast<int>(pixel) % labels.ny;
  std::pair<float, std::int32_t> uphill{0.0f, 0};
  for (int u = x - 1; u <= x + 1; ++u)
    for (int v = y - 1; v <= y + 1; ++v)
      if (labels.contains(u, v) && labels.at(u, v) != 0)
        uphill = std::max(uphill, {field.at(u, v), labels.at(u, v)});
  return uphill.second;
}

/** The flooding word by word, for values that are all different: a pixel belongs to the
 * basin uphill of it; joining basins repaints all their pixels. */
RegionLabels
floodedSlowly(const PixelMap<float>& field, float persistence)
{
  std::vector<std::size_t> order(field.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return field.values[a] > field.values[b];
  });
  PixelMap<std::int32_t> labels{field.nx, field.ny, RegionLabels(field.size(), 0)};
  std::vector<float> maximum{0.0f}; // per label; earlier labels are never lower
  for (const std::size_t pixel : order) {
    const float level = field.values[pixel];
    if (!(level > 0))
      break;
    const auto around = labelsAround(labels, pixel);
    if (around.empty()) {
      labels.values[pixel] = static_cast<std::int32_t>(maximum.size());
      maximum.push_back(level);
      continue;
    }
    const std::int32_t highest = *around.begin();
    labels.values[pixel] = labelUphill(field, labels, pixel);
    for (const auto other : around)
      if (level >= persistence * maximum[other])
        std::replace(labels.values.begin(), labels.values.end(), other, highest);
  }
  return numbered(labels.values);
}

/** Components of the positive pixels (8 neighbours), by spreading the smallest name. */
RegionLabels
componentsBruteForce(const PixelMap<float>& field)
{
  PixelMap<std::int32_t> labels{field.nx, field.ny, {}};
  for (std::size_t i = 0; i < field.size(); ++i)
    labels.values.push_back(field.values[i] > 0 ? static_cast<std::int32_t>(i) + 1 : 0);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < field.size(); ++i)
      if (labels.values[i] && *labelsAround(labels, i).begin() != labels.values[i]) {
        labels.values[i] = *labelsAround(labels, i).begin();
        changed = true;
      }
  }
  return numbered(labels.values);
}

/** Positive values on a share of the pixels: all different, or few and with ties. */
PixelMap<float>
randomField(bool ties, std::mt19937& rng)
{
  PixelMap<float> field{
      1 + static_cast<int>(rng() % 12), 1 + static_cast<int>(rng() % 12), {}};
  const unsigned holes = 1 + rng() % 4;
  for (std::size_t i = 0; i < field.size(); ++i)
    field.values.push_back(rng() % 4 < holes ? 0.0f : 1.0f);
  std::vector<float> values(field.size());
  std::iota(values.begin(), values.end(), 1.0f);
  for (std::size_t i = 0; i < field.size(); ++i) {
    std::swap(values[i], values[i + rng() % (field.size() - i)]);
    field.values[i] *= ties ? static_cast<float>(1 + rng() % 4) : values[i];
  }
  return field;
}

/** Cones of height 10 and 8 whose ridge between them is as high as the pass. */
PixelMap<float>
twoDiscs(float pass)
{
  PixelMap<float> field{25, 50, {}};
  for (int x = 0; x < field.nx; ++x)
    for (int y = 0; y < field.ny; ++y) {
      const float first = 10.0f - std::hypot(x - 12.0f, y - 12.0f);
      const float second = 8.0f - std::hypot(x - 12.0f, y - 36.0f);
      const float way = y >= 12 && y <= 36 ? pass - std::abs(x - 12.0f) : 0.0f;
      field.values.push_back(std::max({0.0f, first, second, way}));
    }
  return field;
}

std::int32_t
countOf(const PixelMap<std::int32_t>& labels)
{
  return *std::max_element(labels.values.begin(), labels.values.end());
}

} // namespace

TEST(PersistentBasins, EqualsSlowFlooding)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 300; ++trial) {
    const auto field = randomField(false, rng);
    const float persistence = static_cast<float>(rng() % 21) / 20;
    EXPECT_EQ(persistentBasins(field, {persistence}).values,
              floodedSlowly(field, persistence))
        << "trial " << trial;
  }
}

TEST(PersistentBasins, PersistenceZeroGivesConnectedComponents)
{
  std::mt19937 rng(2);
  for (int trial = 0; trial < 100; ++trial) {
    const auto field = randomField(trial % 2 == 0, rng);
    EXPECT_EQ(persistentBasins(field, {0.0}).values, componentsBruteForce(field))
        << "trial " << trial;
  }
}

TEST(PersistentBasins, LargerPersistenceGivesNotFewerBasins)
{
  std::mt19937 rng(3);
  for (int trial = 0; trial < 50; ++trial) {
    const auto field = randomField(trial % 2 == 0, rng);
    std::int32_t last = 0;
    for (const float persistence : {0.0f, 0.3f, 0.6f, 0.8f, 1.0f}) {
      const auto count = countOf(persistentBasins(field, {persistence}));
      EXPECT_GE(count, last) << "trial " << trial << ", persistence " << persistence;
      last = count;
    }
  }
}

TEST(PersistentBasins, PlateausAreOneBasin)
{
  EXPECT_EQ(persistentBasins({2, 3, {1, 1, 1, 1, 1, 1}}, {1.0}).values,
            RegionLabels(6, 1));
  // equal maxima with a pass as high as they are
  EXPECT_EQ(persistentBasins({1, 5, {2, 2, 2, 0, 2}}, {1.0}).values,
            (RegionLabels{1, 1, 1, 0, 2}));
}

TEST(PersistentBasins, PassOnEitherSideOfTheThreshold)
{
  for (const float pass : {2.0f, 3.0f, 4.0f, 6.0f}) {
    const auto field = twoDiscs(pass);
    const float share = pass / 8.0f; // of the lower maximum, not of the higher
    const auto joined = persistentBasins(field, {share - 0.01});
    const auto split = persistentBasins(field, {share + 0.01});
    EXPECT_EQ(countOf(joined), 1) << "pass " << pass;
    EXPECT_EQ(countOf(split), 2) << "pass " << pass;
    EXPECT_EQ(split.at(12, 12), 1);
    EXPECT_EQ(split.at(12, 36), 2);
    EXPECT_EQ(split.at(12, 5), 1);
    EXPECT_EQ(split.at(12, 43), 2);
    EXPECT_EQ(split.at(0, 0), 0);
  }
}

TEST(PersistentBasins, DoorsAreNarrowUpToTheirWidth)
{
  // The lower maximum is 8, so that the pass of 5 is narrow for a door alone.
  const auto field = twoDiscs(5.0f);
  EXPECT_EQ(countOf(persistentBasins(field, {0.5, 5.0, 0.75})), 2);
  EXPECT_EQ(countOf(persistentBasins(field, {0.5, 4.9, 0.75})), 1);
  EXPECT_EQ(countOf(persistentBasins(field, {0.5, 5.0, 0.62})), 1);
}

TEST(PersistentBasins, EmptyAndOnePixel)
{
  EXPECT_TRUE(persistentBasins({}, {0.5}).values.empty());
  EXPECT_EQ(persistentBasins({1, 1, {0.0f}}, {0.5}).values, RegionLabels{0});
  EXPECT_EQ(persistentBasins({1, 1, {2.0f}}, {1.0}).values, RegionLabels{1});
}
