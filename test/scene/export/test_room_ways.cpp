/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/room_ways.h"

#include "export/shortest_paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace pcl::indoor::tool;

namespace {

const std::vector<PlanRing> l_shape = {
    {{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}}};

/** The shortest way between two places, as it was found. */
double
lengthOf(const RoomWays& ways, std::size_t from, std::size_t to)
{
  std::vector<WeightedLine> lines;
  for (const auto& [a, b] : ways.lines)
    lines.push_back({a, b, (ways.points[a] - ways.points[b]).norm()});
  return ShortestPaths(ways.points.size(), lines).from(from).lengths[to];
}

} // namespace

TEST(RoomWays, TurnAtTheCorner)
{
  const auto ways = roomWays(l_shape, {{5, 1}, {1, 5}, {5.5, 0.5}}, 0.3);
  const Eigen::Vector2d turn(2.0 - 0.3 * M_SQRT1_2, 2.0 - 0.3 * M_SQRT1_2);
  EXPECT_NEAR(lengthOf(ways, 0, 1),
              (turn - Eigen::Vector2d(5, 1)).norm() +
                  (turn - Eigen::Vector2d(1, 5)).norm(),
              1e-9);
  EXPECT_NEAR(lengthOf(ways, 0, 2), M_SQRT1_2, 1e-9);
  for (const auto& [a, b] : ways.lines)
    EXPECT_TRUE(seesEachOther(l_shape, ways.points[a], ways.points[b]));
}

TEST(RoomWays, EveryPlaceIsReached)
{
  const auto ways = roomWays(l_shape, {{1, 1}, {20, 20}}, 0.3); // outside
  EXPECT_TRUE(std::isfinite(lengthOf(ways, 0, 1)));
  EXPECT_TRUE(roomWays({}, {}, 0.3).lines.empty());
}

TEST(RoomWays, LinesThroughWallsAreNoWays)
{
  EXPECT_FALSE(seesEachOther(l_shape, {5, 1}, {1, 5}));
  EXPECT_TRUE(seesEachOther(l_shape, {5, 1}, {1, 1}));
  EXPECT_FALSE(
      seesEachOther(l_shape, {6, 2}, {2, 6})); // outside, from corner to corner
}

TEST(ShortestPaths, AreThoseOfAllPairs)
{
  std::mt19937 rng(7);
  for (int trial = 0; trial < 50; ++trial) {
    const std::size_t n = 2 + rng() % 12;
    std::vector<WeightedLine> lines;
    std::vector<std::vector<double>> all(n, std::vector<double>(n, INFINITY));
    for (std::size_t i = 0; i < n; ++i)
      all[i][i] = 0.0;
    for (std::size_t i = 0; i < 2 * n; ++i) {
      lines.push_back({rng() % n, rng() % n, 1.0 + rng() % 9});
      const auto& line = lines.back();
      all[line.a][line.b] = std::min(all[line.a][line.b], line.length);
      all[line.b][line.a] = std::min(all[line.b][line.a], line.length);
    }
    for (std::size_t k = 0; k < n; ++k) // Floyd and Warshall
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          all[i][j] = std::min(all[i][j], all[i][k] + all[k][j]);
    const auto paths = ShortestPaths(n, lines).from(0);
    EXPECT_EQ(paths.lengths, all[0]) << "trial " << trial;
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_EQ(paths.to(i).empty(), std::isinf(all[0][i]));
  }
}
