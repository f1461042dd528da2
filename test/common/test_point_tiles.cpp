/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/indoor/point_tiles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>

using namespace pcl::indoor;

namespace {

using FoundPlaces = std::multiset<std::pair<double, double>>;

template <typename Tiles>
FoundPlaces
placesNear(const Tiles& tiles, const Eigen::Array2d& low, const Eigen::Array2d& high)
{
  FoundPlaces places;
  tiles.forEachNear(low, high, [&](const auto* first, const auto* end) {
    for (; first != end; ++first)
      places.emplace((*first)[0], (*first)[1]);
  });
  return places;
}

} // namespace

TEST(PointTiles, ABoxHoldsAllItsPointsOnceAndNoneFarOff)
{
  std::mt19937 rng(1);
  std::uniform_real_distribution<double> place(-20, 30), length(0, 8);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < 300; ++i)
      points.emplace_back(place(rng), place(rng));
    points.push_back(points.front()); // a copy counts, too
    const PointTiles<Eigen::Vector2d> tiles(points, 2.0);
    const Eigen::Array2d low(place(rng), place(rng));
    const Eigen::Array2d high = low + Eigen::Array2d(length(rng), length(rng));
    FoundPlaces inside, around;
    for (const auto& point : points) {
      if ((point.array() >= low).all() && (point.array() <= high).all())
        inside.emplace(point.x(), point.y());
      if ((point.array() >= low - tiles.size()).all() &&
          (point.array() <= high + tiles.size()).all())
        around.emplace(point.x(), point.y());
    }
    const auto found = placesNear(tiles, low, high);
    EXPECT_TRUE(
        std::includes(found.begin(), found.end(), inside.begin(), inside.end()));
    EXPECT_TRUE(
        std::includes(around.begin(), around.end(), found.begin(), found.end()));
  }
}

TEST(PointTiles, ALongRowOfFewPointsHasFewTiles)
{
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 10; ++i)
    points.emplace_back(1e6f * static_cast<float>(i), 0.0f, 5.0f);
  const PointTiles<Eigen::Vector3f> tiles(points, 1.0);
  EXPECT_GE(tiles.size(), 9e5);
  EXPECT_EQ(placesNear(tiles, {-1e9, -1e9}, {1e9, 1e9}).size(), points.size());
}

TEST(PointTiles, NoPointsAreNowhere)
{
  const PointTiles<Eigen::Vector3f> tiles(std::vector<Eigen::Vector3f>{}, 1.0);
  EXPECT_TRUE(tiles.empty());
  EXPECT_TRUE(placesNear(tiles, {-1, -1}, {1, 1}).empty());
}
