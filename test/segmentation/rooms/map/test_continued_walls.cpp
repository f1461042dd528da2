/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/continued_walls.h"

#include <gtest/gtest.h>

using namespace pcl::indoor;
using Blocked = PixelMap<std::uint8_t>;

namespace {

constexpr double pixel_size = 0.1; // metres

Blocked
nothing()
{
  Blocked map{60, 40, {}};
  map.values.assign(map.size(), 0);
  return map;
}

void
fill(Blocked& map, int x0, int x1, int y0, int y1)
{
  for (int x = x0; x <= x1; ++x)
    for (int y = y0; y <= y1; ++y)
      map.at(x, y) = 1;
}

Blocked
turned(const Blocked& map)
{
  Blocked result{map.ny, map.nx, {}};
  result.values.assign(map.size(), 0);
  for (int x = 0; x < map.nx; ++x)
    for (int y = 0; y < map.ny; ++y)
      result.at(y, x) = map.at(x, y);
  return result;
}

int
count(const Blocked& map, int x0, int x1, int y)
{
  int count = 0;
  for (int x = x0; x <= x1; ++x)
    count += map.at(x, y);
  return count;
}

TEST(ContinuedWalls, GoOnWhereTheyWereSeenLower)
{
  Blocked high = nothing(), low = nothing();
  fill(high, 5, 24, 20, 20); // 2 m
  fill(low, 5, 44, 20, 20);  // of 4 m
  const auto walls = continuedWalls(high, low, pixel_size);
  EXPECT_EQ(walls.values, low.values);
  EXPECT_EQ(continuedWalls(turned(high), turned(low), pixel_size).values,
            turned(low).values);
}

TEST(ContinuedWalls, GoOnBesideTheirLine)
{
  Blocked high = nothing(), low = nothing();
  fill(high, 5, 24, 20, 20);
  fill(low, 25, 44, 21, 21); // a map that drifts
  const auto walls = continuedWalls(high, low, pixel_size);
  EXPECT_EQ(count(walls, 25, 44, 21), 20);
}

TEST(ContinuedWalls, EndAtDoors)
{
  Blocked high = nothing(), low = nothing();
  fill(high, 5, 24, 20, 20);
  fill(low, 34, 50, 20, 20); // beyond a door of 0.9 m
  EXPECT_EQ(continuedWalls(high, low, pixel_size).values, high.values);
}

TEST(ContinuedWalls, CabinetsAtAWallAreNone)
{
  Blocked high = nothing(), low = nothing();
  fill(high, 5, 50, 5, 5);
  fill(low, 20, 23, 6, 25); // stands out from it by 2 m
  const auto walls = continuedWalls(high, low, pixel_size);
  for (int y = 7; y <= 25; ++y) // what touches the wall may be part of it
    EXPECT_EQ(count(walls, 0, 59, y), 0) << y;
}

TEST(ContinuedWalls, RowsOfFurnitureAreNoneWhereAFewPiecesAreHigh)
{
  Blocked high = nothing(), low = nothing();
  fill(low, 5, 50, 20, 20);
  fill(high, 20, 31, 20, 20); // 1.2 of 4.6 m
  EXPECT_EQ(continuedWalls(high, low, pixel_size).values, high.values);
  fill(high, 32, 33, 20, 20); // 1.4 m
  EXPECT_EQ(continuedWalls(high, low, pixel_size).values, low.values);
}

} // namespace
