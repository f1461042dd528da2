/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "objects/join/room_columns.h"
#include "segmentation/objects/join/outline_of.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

constexpr double column_voxel_size = 0.05, cell = 0.01; // m, m^2 of a column

/** Voxels in the middles of columns, x from 0 to 1.5 m, y from 0 to 1. */
void
addLevel(float x0, float x1, float height, Places& voxels)
{
  for (int i = 0; i < 15; ++i)
    for (int j = 0; j < 10; ++j) {
      const float x = 0.05f + 0.1f * static_cast<float>(i);
      if (x0 < x && x < x1)
        voxels.emplace_back(x, 0.05f + 0.1f * static_cast<float>(j), height);
    }
}

/** A corner that makes columns begin at zero. */
Places
corner()
{
  return {{0, 0, 0}};
}

/** Two tables, x to 0.5 and from 1 on, 0.7 m high, on a floor that is seen from x = 0.3
 * on. */
Places
twoTables()
{
  auto voxels = corner();
  addLevel(0.3f, 1.5f, 0, voxels);
  addLevel(0, 0.5f, 0.7f, voxels);
  addLevel(1, 1.5f, 0.7f, voxels);
  return voxels;
}

const KDop16 left = rectangle(0, 0, 0.5f, 1), right = rectangle(1, 0, 1.5f, 1);

} // namespace

TEST(RoomColumns, FloorIsSeenBetweenLegs)
{
  const RoomColumns room(twoTables(), 0, column_voxel_size);
  EXPECT_NEAR(room.areaOfFloor(left), 20 * cell + cell, 1e-9); // and the corner
  EXPECT_NEAR(room.areaOfFloor(right), 50 * cell, 1e-9);
  EXPECT_NEAR(room.areaOfFloor(rectangle(0.32f, 0.22f, 0.48f, 0.38f)), 4 * cell, 1e-9);
  EXPECT_EQ(room.areaOfFloor(rectangle(5, 5, 6, 6)), 0);
}

TEST(RoomColumns, BetweenTablesTheFloorIsOpen)
{
  const RoomColumns room(twoTables(), 0, column_voxel_size);
  for (const RoomColumns::Heights heights :
       {RoomColumns::Heights{0.6, 0.8}, {0.8, 0.6}}) {
    const auto gap = room.areaBetween(left, right, heights);
    EXPECT_NEAR(gap.open, 50 * cell, 1e-9);
    EXPECT_EQ(gap.filled, 0);
  }
}

TEST(RoomColumns, WhatStandsBetweenFillsTheGapAtItsHeights)
{
  auto voxels = twoTables();
  addLevel(0.5f, 0.7f, 0.7f, voxels);
  addLevel(0.8f, 0.9f, 0.3f, voxels);
  const RoomColumns room(voxels, 0, column_voxel_size);
  const auto high = room.areaBetween(left, right, {0.6, 0.8});
  EXPECT_NEAR(high.filled, 20 * cell, 1e-9);
  EXPECT_NEAR(high.open, 30 * cell, 1e-9);
  const auto low = room.areaBetween(left, right, {0.2, 0.4});
  EXPECT_NEAR(low.filled, 10 * cell, 1e-9);
  EXPECT_NEAR(low.open, 40 * cell, 1e-9);
  const auto hidden = room.areaBetween(left, right, {0.9, 1.2});
  EXPECT_EQ(hidden.filled, 0);
  EXPECT_NEAR(hidden.open, 50 * cell, 1e-9);
}

TEST(RoomColumns, WhatWasNotSeenIsNeitherOpenNorFilled)
{
  auto voxels = corner();
  addLevel(0, 0.5f, 0.7f, voxels);
  addLevel(1, 1.5f, 0.7f, voxels);
  const auto gap =
      RoomColumns(voxels, 0, column_voxel_size).areaBetween(left, right, {0.6, 0.8});
  EXPECT_EQ(gap.open, 0);
  EXPECT_EQ(gap.filled, 0);
}

TEST(RoomColumns, StepsEndAtTheLowestAndTheHighest)
{
  Places voxels = corner(), far_up = corner();
  addLevel(0, 1.5f, -3, voxels);
  addLevel(0, 1.5f, 50, far_up);
  const RoomColumns low(voxels, 0, column_voxel_size),
      high(far_up, 0, column_voxel_size);
  EXPECT_NEAR(low.areaOfFloor(left), 50 * cell, 1e-9)
      << "what is lower counts as floor";
  EXPECT_NEAR(high.areaOfFloor(left), cell, 1e-9);
  EXPECT_NEAR(high.areaBetween(left, right, {30, 40}).filled, 50 * cell, 1e-9);
  EXPECT_EQ(high.areaBetween(left, right, {1, 2}).filled, 0);
}

TEST(RoomColumns, AreTheSameWhereverTheRoomIs)
{
  auto moved = twoTables();
  const Eigen::Vector3f shift(100, -200, 7);
  for (auto& voxel : moved)
    voxel += shift;
  const RoomColumns here(twoTables(), 0, column_voxel_size),
      there(moved, 7, column_voxel_size);
  const auto outline = rectangle(100.02f, -199.98f, 100.48f, -199.02f);
  EXPECT_NEAR(here.areaOfFloor(rectangle(0.02f, 0.02f, 0.48f, 0.98f)),
              there.areaOfFloor(outline),
              1e-9);
}

TEST(RoomColumns, AgreeWithCountingByTheLetter)
{
  std::mt19937 rng(4);
  const auto random = [&](int range) { // never between two columns or steps
    return (static_cast<float>(rng() % 1000) + 0.5f) * static_cast<float>(range) / 1000;
  };
  for (int trial = 0; trial < 20; ++trial) {
    auto voxels = corner();
    std::map<std::pair<int, int>, std::vector<int>> steps; // 10 cm, the first at -5 cm
    steps[{0, 0}].push_back(0);
    for (int v = 0; v < 600; ++v) {
      const float x = random(3), y = random(2), z = random(2);
      voxels.emplace_back(x, y, z);
      steps[{static_cast<int>(x / 0.1f), static_cast<int>(y / 0.1f)}].push_back(
          static_cast<int>((z + 0.05f) / 0.1f));
    }
    Places places_a, places_b;
    for (int i = 0; i < 4; ++i) {
      places_a.emplace_back(random(2), random(2), 0);
      places_b.emplace_back(1 + random(2), random(2), 0);
    }
    const auto a = outlineOf(places_a), b = outlineOf(places_b);
    int floor = 0, open = 0, filled = 0;
    for (const auto& [place, heights] : steps) {
      const double x = 0.1 * place.first + 0.05, y = 0.1 * place.second + 0.05;
      bool has_floor = false, has_between = false, has_below = false;
      for (const int step : heights) {
        has_floor |= step <= 1;
        has_between |= step >= 6 && step <= 9; // 0.6 to 0.9 m
        has_below |= step < 6;
      }
      floor += has_floor && isWithin(a, x, y);
      if (!isWithin(hullOfBoth(a, b), x, y) || isWithin(a, x, y) || isWithin(b, x, y))
        continue;
      filled += has_between;
      open += has_below && !has_between;
    }
    const RoomColumns room(voxels, 0, column_voxel_size);
    const auto gap = room.areaBetween(a, b, {0.6, 0.9});
    EXPECT_NEAR(room.areaOfFloor(a), floor * cell, 1e-9);
    EXPECT_NEAR(gap.open, open * cell, 1e-9);
    EXPECT_NEAR(gap.filled, filled * cell, 1e-9);
  }
}

TEST(RoomColumns, AnEmptyRoomHasNothing)
{
  const RoomColumns none;
  EXPECT_EQ(none.areaOfFloor(left), 0);
  EXPECT_EQ(none.areaBetween(left, right, {0, 1}).open, 0);
}
