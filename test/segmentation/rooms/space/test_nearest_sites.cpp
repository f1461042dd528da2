/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/nearest_sites.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

using pcl::indoor::nearestSites;
using pcl::indoor::PixelMap;

namespace {

constexpr std::int32_t none = std::numeric_limits<std::int32_t>::max();

PixelMap<std::uint8_t>
randomSites(int nx, int ny, unsigned sparsity, std::mt19937& rng)
{
  PixelMap<std::uint8_t> sites{nx, ny, {}};
  for (std::size_t i = 0; i < sites.size(); ++i)
    sites.values.push_back(rng() % sparsity == 0 ? 1 + rng() % 255 : 0);
  return sites;
}

std::int32_t
squaredDistance(int nx, int ny, std::size_t a, std::size_t b)
{
  EXPECT_LT(std::max(a, b), static_cast<std::size_t>(nx) * ny);
  const int dx = static_cast<int>(a / ny) - static_cast<int>(b / ny);
  const int dy = static_cast<int>(a % ny) - static_cast<int>(b % ny);
  return dx * dx + dy * dy;
}

template <typename T>
std::int32_t
nearestBruteForce(const PixelMap<T>& sites, std::size_t pixel)
{
  std::int32_t nearest = none;
  for (std::size_t i = 0; i < sites.size(); ++i)
    if (sites.values[i])
      nearest = std::min(nearest, squaredDistance(sites.nx, sites.ny, i, pixel));
  return nearest;
}

} // namespace

TEST(NearestSites, EqualsBruteForceWithTiesByDistance)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 200; ++trial) {
    const int nx = 1 + rng() % 15, ny = 1 + rng() % 15;
    const auto sites = randomSites(nx, ny, 1 + rng() % 60, rng);
    const auto nearest = nearestSites(sites);
    ASSERT_EQ(nearest.site.values.size(), sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const std::int32_t expected = nearestBruteForce(sites, i);
      ASSERT_EQ(nearest.squared_distance.values[i], expected) << "trial " << trial;
      const std::int32_t site = nearest.site.values[i];
      if (expected == none) {
        ASSERT_EQ(site, -1) << "trial " << trial;
        continue;
      }
      ASSERT_TRUE(sites.values[site]) << "trial " << trial;
      ASSERT_EQ(squaredDistance(nx, ny, i, site), expected) << "trial " << trial;
    }
  }
}

TEST(NearestSites, IsTheSameForTheSameMap)
{
  std::mt19937 rng(2);
  const auto sites = randomSites(40, 30, 20, rng);
  EXPECT_EQ(nearestSites(sites).site.values, nearestSites(sites).site.values);
}

TEST(NearestSites, EmptyMapsAndMapsWithoutSites)
{
  EXPECT_TRUE(nearestSites({}).site.values.empty());
  EXPECT_EQ(nearestSites({1, 1, {0}}).site.values, std::vector<std::int32_t>{-1});
  EXPECT_EQ(nearestSites({1, 1, {1}}).squared_distance.values,
            std::vector<std::int32_t>{0});
  const auto nearest = nearestSites({2, 3, std::vector<std::uint8_t>(6, 0)});
  EXPECT_EQ(nearest.site.values, std::vector<std::int32_t>(6, -1));
  EXPECT_EQ(nearest.squared_distance.values, std::vector<std::int32_t>(6, none));
}

TEST(NearestSites, LongLinesKeepTheirPrecision)
{
  // 40,000 pixels squared need 31 bits: a float on the way would not be exact.
  PixelMap<std::uint8_t> sites{40000, 3, {}};
  sites.values.assign(sites.size(), 0);
  for (const int x : {0, 39960, 39971, 39978, 39985, 39990, 39994})
    sites.at(x, x % 3) = 1;
  const auto nearest = nearestSites(sites);
  for (const int x : {20000, 39955, 39966, 39975, 39982, 39988, 39992, 39999})
    for (int y = 0; y < 3; ++y)
      EXPECT_EQ(nearest.squared_distance.at(x, y),
                nearestBruteForce(sites, sites.index(x, y)))
          << x;
  sites.values.assign(sites.size(), 0);
  sites.at(0, 0) = 1;
  EXPECT_EQ(nearestSites(sites).squared_distance.at(39999, 1), 39999 * 39999 + 1);
}

TEST(GrowLabels, ReachesNearPixelsOnlyAndKeepsLabels)
{
  std::mt19937 rng(3);
  for (int trial = 0; trial < 100; ++trial) {
    PixelMap<std::int32_t> labels{
        1 + static_cast<int>(rng() % 12), 1 + static_cast<int>(rng() % 12), {}};
    for (std::size_t i = 0; i < labels.size(); ++i)
      labels.values.push_back(rng() % 9 == 0 ? 1 + static_cast<int>(rng() % 5) : 0);
    const double reach = 0.25 * static_cast<double>(rng() % 24);
    auto grown = labels;
    pcl::indoor::growLabels(grown, reach);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const std::int32_t distance = nearestBruteForce(labels, i);
      const std::int32_t label = grown.values[i];
      if (labels.values[i]) {
        ASSERT_EQ(label, labels.values[i]) << "trial " << trial;
        continue;
      }
      if (distance == none || distance > reach * reach) {
        ASSERT_EQ(label, 0) << "trial " << trial;
        continue;
      }
      bool found = false; // one of the nearest labelled pixels has this label
      for (std::size_t k = 0; k < labels.size(); ++k)
        found = found || (labels.values[k] == label && label != 0 &&
                          squaredDistance(labels.nx, labels.ny, i, k) == distance);
      ASSERT_TRUE(found) << "trial " << trial;
    }
  }
  PixelMap<std::int32_t> empty;
  pcl::indoor::growLabels(empty, 1.0);
  EXPECT_TRUE(empty.values.empty());
}

TEST(NearestSites, DistancesBeyondTheRangeAreTheLargestOnes)
{
  PixelMap<std::uint8_t> sites{50000, 1, {}};
  sites.values.assign(sites.size(), 0);
  sites.values.back() = 1;
  const auto nearest = nearestSites(sites);
  EXPECT_EQ(nearest.site.values.front(), 49999);
  EXPECT_EQ(nearest.squared_distance.values.front(), none - 1);
  EXPECT_EQ(nearest.squared_distance.values[49999 - 46000], 46000 * 46000);
}
