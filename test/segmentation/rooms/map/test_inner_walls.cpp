/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/inner_walls.h"
#include "rooms/space/map_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <vector>

using pcl::indoor::divideAtInnerWalls;
using pcl::indoor::forEachRegion;
using pcl::indoor::Neighbours;
using Rooms = pcl::indoor::PixelMap<std::int32_t>;

namespace {

const std::vector<Eigen::Vector2d> along_axes = {{1, 0}, {0, 1}};

/** \brief A room of 60 x 40 pixels within a border of walls. */
Rooms
room()
{
  Rooms rooms{62, 42, {}};
  rooms.values.assign(rooms.size(), 0);
  for (int x = 1; x <= 60; ++x)
    for (int y = 1; y <= 40; ++y)
      rooms.at(x, y) = 1;
  return rooms;
}

void
fill(Rooms& rooms, int x0, int x1, int y0, int y1, std::int32_t value)
{
  for (int x = x0; x <= x1; ++x)
    for (int y = y0; y <= y1; ++y)
      rooms.at(x, y) = value;
}

std::size_t
pixelsOf(const Rooms& rooms, std::int32_t label)
{
  return std::count(rooms.values.begin(), rooms.values.end(), label);
}

} // namespace

TEST(DivideAtInnerWalls, AWallFillsEnoughOfItsLineOrNot)
{
  for (const int length : {22, 23, 24, 30}) { // of 60 pixels
    Rooms rooms = room();
    fill(rooms, 1, length, 15, 17, 0);
    const Rooms before = rooms;
    std::int32_t count = 1;
    divideAtInnerWalls(rooms, count, along_axes, 5, 0.4, 100);
    if (length < 24) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(rooms.values, before.values) << length;
      continue;
    }
    EXPECT_EQ(count, 2);
    EXPECT_EQ(rooms.at(40, 30), 1) << "the larger part keeps its number";
    EXPECT_EQ(rooms.at(40, 5), 2);
    EXPECT_EQ(pixelsOf(rooms, 0), pixelsOf(before, 0)); // no pixel is lost
  }
}

TEST(DivideAtInnerWalls, GapsMayBeAnywhereOnTheLine)
{
  Rooms rooms = room();
  fill(rooms, 10, 21, 20, 21, 0);
  fill(rooms, 35, 48, 20, 21, 0);
  std::int32_t count = 1;
  divideAtInnerWalls(rooms, count, along_axes, 5, 0.4, 100);
  EXPECT_EQ(count, 2);
  EXPECT_NE(rooms.at(5, 5), rooms.at(5, 35));
  EXPECT_EQ(rooms.at(5, 5), rooms.at(55, 5));
}

TEST(DivideAtInnerWalls, NeitherThickWallsNorSmallPartsNorTheCornerOfAnLCount)
{
  Rooms thick = room();
  fill(thick, 1, 30, 15, 20, 0);
  Rooms small = room();
  fill(small, 1, 30, 3, 4, 0); // 120 pixels beyond it
  Rooms corner = room();
  fill(corner, 1, 30, 1, 20, 0); // walls, but nothing of the room behind them
  for (Rooms* rooms : {&thick, &small, &corner}) {
    const Rooms before = *rooms;
    std::int32_t count = 1;
    divideAtInnerWalls(*rooms, count, along_axes, 5, 0.4, 121);
    EXPECT_EQ(count, 1);
    EXPECT_EQ(rooms->values, before.values);
  }
}

TEST(DivideAtInnerWalls, WallsInAnyGivenDirectionOtherRoomsStay)
{
  Rooms rooms = room();
  const Eigen::Vector2d direction(2, 1);
  for (int x = 1; x <= 40; ++x)
    for (int k = 0; k < 3; ++k)
      rooms.at(x, 8 + (x + 1) / 2 + k) = 0;
  fill(rooms, 50, 60, 1, 5, 2); // another room
  Rooms along_x = rooms;
  std::int32_t count = 2;
  divideAtInnerWalls(along_x, count, along_axes, 6, 0.4, 100);
  EXPECT_EQ(count, 2);
  divideAtInnerWalls(rooms, count, {direction}, 6, 0.4, 100);
  EXPECT_EQ(count, 3);
  EXPECT_NE(rooms.at(5, 2), rooms.at(5, 35));
  EXPECT_EQ(rooms.at(55, 3), 2);
  EXPECT_EQ(pixelsOf(rooms, 2), 55u);
}

TEST(ForEachRegion, EqualsJoiningOfNeighbours)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 100; ++trial) {
    Rooms map{1 + static_cast<int>(rng() % 12), 1 + static_cast<int>(rng() % 12), {}};
    for (std::size_t i = 0; i < map.size(); ++i)
      map.values.push_back(static_cast<std::int32_t>(rng() % 3));
    const auto neighbours = trial % 2 ? Neighbours::Four : Neighbours::Eight;
    std::vector<std::size_t> smallest(map.size()); // pixel of the region
    std::iota(smallest.begin(), smallest.end(), std::size_t{0});
    const int ny = map.ny;
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t a = 0; a < map.size(); ++a)
        for (std::size_t b = 0; b < map.size(); ++b) {
          const int dx = std::abs(static_cast<int>(a / ny) - static_cast<int>(b / ny));
          const int dy = std::abs(static_cast<int>(a % ny) - static_cast<int>(b % ny));
          const bool near =
              neighbours == Neighbours::Four ? dx + dy == 1 : std::max(dx, dy) == 1;
          if (near && map.values[a] == map.values[b] && smallest[b] < smallest[a]) {
            smallest[a] = smallest[b];
            changed = true;
          }
        }
    }
    std::set<std::set<std::size_t>> expected, found;
    for (std::size_t start = 0; start < map.size(); ++start) {
      std::set<std::size_t> region;
      for (std::size_t i = 0; i < map.size(); ++i)
        if (smallest[i] == start && map.values[i] != 0)
          region.insert(i);
      if (!region.empty())
        expected.insert(region);
    }
    forEachRegion(map, neighbours, [&](const auto& region) {
      EXPECT_TRUE(found.emplace(region.begin(), region.end()).second);
    });
    EXPECT_EQ(found, expected) << "trial " << trial;
  }
}
