/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/distance_map.h"
#include "rooms/space/greatest_around.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using pcl::indoor::kNoObstacle;
using pcl::indoor::PixelMap;

TEST(SquaredDistanceMap, EmptyMapGivesAnEmptyOne)
{
  EXPECT_TRUE(pcl::indoor::squaredDistanceMap({}).values.empty());
}

TEST(SquaredDistanceMap, EqualsBruteForce)
{
  std::mt19937 rng(3);
  for (int trial = 0; trial < 150; ++trial) {
    PixelMap<std::uint8_t> map{
        1 + static_cast<int>(rng() % 40), 1 + static_cast<int>(rng() % 40), {}};
    map.values.resize(map.size());
    const unsigned sparsity = 1 + rng() % 300;
    for (auto& value : map.values)
      value = rng() % sparsity == 0;
    const auto distances = pcl::indoor::squaredDistanceMap(map);
    for (int x = 0; x < map.nx; ++x)
      for (int y = 0; y < map.ny; ++y) {
        std::uint32_t best = kNoObstacle;
        for (int u = 0; u < map.nx; ++u)
          for (int v = 0; v < map.ny; ++v)
            if (map.at(u, v)) {
              const int d = (u - x) * (u - x) + (v - y) * (v - y);
              best = std::min(best, static_cast<std::uint32_t>(d));
            }
        ASSERT_EQ(distances.at(x, y), best) << "trial " << trial;
      }
  }
}

TEST(GreatestAround, EqualsBruteForce)
{
  std::mt19937 rng(9);
  for (int trial = 0; trial < 100; ++trial) {
    const int nx = 1 + static_cast<int>(rng() % 12),
              ny = 1 + static_cast<int>(rng() % 12);
    const int radius = static_cast<int>(rng() % 15);
    auto map = pcl::indoor::PixelMap<int>::filled(nx, ny, 0);
    for (int& value : map.values)
      value = static_cast<int>(rng() % 100) - 70; // most are negative
    const auto greatest = pcl::indoor::greatestAround(map, radius);
    for (int x = 0; x < nx; ++x)
      for (int y = 0; y < ny; ++y) {
        int expected = map.at(x, y);
        for (int u = 0; u < nx; ++u)
          for (int v = 0; v < ny; ++v)
            if (std::abs(u - x) <= radius && std::abs(v - y) <= radius)
              expected = std::max(expected, map.at(u, v));
        ASSERT_EQ(greatest.at(x, y), expected) << "radius " << radius;
      }
  }
}
