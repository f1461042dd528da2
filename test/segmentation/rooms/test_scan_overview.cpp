/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/synthetic_scenes.h"

#include <pcl/segmentation/scan_overview.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

using Points = std::vector<Eigen::Vector3f>;

constexpr float storey_height = 2.8f; // of the house, metres

/** Storeys of 2.5 m, each with four rooms of 4 x 5 m. */
Points
house(int storeys = 2, float spacing = 0.05f)
{
  std::vector<RoomBox> boxes;
  for (int storey = 0; storey < storeys; ++storey)
    for (int x = 0; x < 2; ++x)
      for (int y = 0; y < 2; ++y) {
        const Eigen::Vector3f low(4.2f * x, 5.2f * y, storey_height * storey);
        boxes.push_back({low, low + Eigen::Vector3f(4, 5, 2.5f), 1});
      }
  return rooms(boxes, {}, spacing).points;
}

template <typename Predicate>
Points
without(Points points, const Predicate& is_gone)
{
  points.erase(std::remove_if(points.begin(), points.end(), is_gone), points.end());
  return points;
}

bool
isCeiling(const Eigen::Vector3f& p)
{
  return p.z() > 2.4f;
}

bool
isFloor(const Eigen::Vector3f& p)
{
  return p.z() < 0.1f;
}

void
expectSame(const ScanOverview& a, const ScanOverview& b)
{
  EXPECT_EQ(a.spacing, b.spacing);
  EXPECT_EQ(a.extent, b.extent);
  EXPECT_EQ(a.storeys, b.storeys);
  EXPECT_EQ(a.area, b.area);
  EXPECT_EQ(a.open_area, b.open_area);
  EXPECT_EQ(a.floor_seen, b.floor_seen);
  EXPECT_EQ(a.ceiling_seen, b.ceiling_seen);
  EXPECT_EQ(a.wall_sides, b.wall_sides);
  EXPECT_EQ(a.room_height, b.room_height);
  EXPECT_EQ(a.duplicates, b.duplicates);
}

} // namespace

TEST(ScanOverview, AWholeHouseIsSeen)
{
  const auto overview = scanOverview(house());
  EXPECT_NEAR(overview.spacing, 0.05, 0.01);
  EXPECT_NEAR(overview.extent.x(), 8.2, 0.1);
  EXPECT_NEAR(overview.extent.y(), 10.2, 0.1);
  EXPECT_NEAR(overview.extent.z(), 5.3, 0.1);
  EXPECT_EQ(overview.storeys, 2u);
  EXPECT_GT(overview.floor_seen, 0.97);
  EXPECT_GT(overview.ceiling_seen, 0.97);
  EXPECT_GT(overview.wall_sides, 3.9);
  EXPECT_NEAR(overview.room_height, 2.5, 0.05);
  EXPECT_EQ(overview.duplicates, 0.0);
  EXPECT_EQ(overview.open_area, 0.0);
  EXPECT_NEAR(overview.area, 2 * 4 * 4.0 * 5.0, 0.15 * 160); // without voxels of walls
}

TEST(ScanOverview, HalfOfACeilingIsHalf)
{
  const auto overview = scanOverview(
      without(house(1), [](const auto& p) { return isCeiling(p) && p.y() > 5.1f; }));
  EXPECT_NEAR(overview.ceiling_seen, 0.5, 0.06);
  EXPECT_GT(overview.floor_seen, 0.97);
  EXPECT_NEAR(overview.room_height, 2.5, 0.05);
}

TEST(ScanOverview, WhatLacksIsNotSeen)
{
  const auto no_ceiling = scanOverview(without(house(1), isCeiling));
  EXPECT_GT(no_ceiling.floor_seen, 0.97);
  EXPECT_LT(no_ceiling.ceiling_seen, 0.03);
  EXPECT_EQ(no_ceiling.room_height, 0.0);
  const auto no_floor = scanOverview(without(house(1), isFloor));
  EXPECT_LT(no_floor.floor_seen, 0.03);
  EXPECT_GT(no_floor.ceiling_seen, 0.97);
  const auto walls = scanOverview(
      without(house(1), [](const auto& p) { return isFloor(p) || isCeiling(p); }));
  EXPECT_LT(walls.floor_seen, 0.03);
  EXPECT_LT(walls.ceiling_seen, 0.03);
  const auto floor = scanOverview(
      without(house(1), [](const auto& p) { return !isFloor(p) && !isCeiling(p); }));
  EXPECT_GT(floor.floor_seen, 0.97);
  EXPECT_EQ(floor.wall_sides, 0.0);
}

TEST(ScanOverview, ASliceHasNoMoreThanItsSize)
{
  const auto overview = scanOverview(
      without(house(1), [](const auto& p) { return p.z() < 1.0f || p.z() > 1.4f; }));
  EXPECT_NEAR(overview.extent.z(), 0.4, 0.05);
  EXPECT_EQ(overview.storeys, 0u);
  EXPECT_EQ(overview.floor_seen, 0.0);
}

TEST(ScanOverview, OutdoorsIsNoUnseenCeiling)
{
  auto points = house(1);
  std::mt19937 random(5);
  for (int i = 0; i < 200000; ++i) { // a garden around the house
    const Eigen::Vector3f p(-8.0f + 0.001f * (random() % 24000),
                            -8.0f + 0.001f * (random() % 26000),
                            -0.1f);
    if (p.x() < -0.2f || p.x() > 8.4f || p.y() < -0.2f || p.y() > 10.4f)
      points.push_back(p);
  }
  const auto overview = scanOverview(points);
  EXPECT_GT(overview.ceiling_seen, 0.9);
  EXPECT_GT(overview.open_area, 400.0);
}

TEST(ScanOverview, DuplicatesAreCounted)
{
  auto points = house(1);
  const auto size = points.size();
  for (std::size_t i = 0; i < size; i += 2)
    points.push_back(points[i]);
  const auto overview = scanOverview(points);
  EXPECT_NEAR(overview.duplicates, 1.0 / 3.0, 0.02);
  EXPECT_NEAR(overview.spacing, 0.05, 0.01);
}

TEST(ScanOverview, FollowsUnitAndUpAxis)
{
  const auto upright = scanOverview(house(1));
  Points lying; // x up, millimetres
  for (const auto& p : house(1))
    lying.emplace_back(1000.0f * p.z(), 1000.0f * p.x(), 1000.0f * p.y());
  const auto overview = scanOverview(lying, Eigen::Vector3f::UnitX(), 0.001);
  EXPECT_NEAR(overview.extent.z(), 2.5, 0.05);
  EXPECT_NEAR(overview.room_height, upright.room_height, 0.01);
  EXPECT_NEAR(overview.floor_seen, upright.floor_seen, 0.02);
  EXPECT_NEAR(overview.ceiling_seen, upright.ceiling_seen, 0.02);
}

TEST(ScanOverview, DependsNeitherOnTheOrderNorOnFarPoints)
{
  auto points = house(4, 0.03f); // more than are looked at
  const auto overview = scanOverview(points);
  std::mt19937 random(1);
  for (std::size_t i = points.size() - 1; i > 0; --i)
    std::swap(points[i], points[random() % (i + 1)]);
  expectSame(scanOverview(points), overview);
  points.emplace_back(9e8f, 0.0f, 0.0f);
  EXPECT_NEAR(scanOverview(points).floor_seen, overview.floor_seen, 0.01);
}

TEST(ScanOverview, FewPointsAreNothing)
{
  EXPECT_EQ(scanOverview({}).spacing, 0.0);
  EXPECT_EQ(scanOverview({{1, 2, 3}}).storeys, 0u);
  EXPECT_EQ(scanOverview({{1, 2, 3}, {1, 2, 3}}).duplicates, 0.5);
}
