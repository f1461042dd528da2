/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/outline/room_footprint.h"
#include "rooms/outline/room_outline.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include "segmentation/rooms/outline/empty_map.h"

#include <cmath>
#include <random>

using namespace pcl::indoor;
using pcl::indoor::test::emptyMap;

namespace {

using Line = std::vector<Eigen::Vector2d>;

/** Points on the sides of a rectangle, with noise across, turned about the origin. */
Line
wallsOf(const Eigen::AlignedBox2d& box, double noise, double yaw, std::mt19937& rng)
{
  std::normal_distribution<double> across(0.0, noise);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const Eigen::Rotation2Dd turn(yaw);
  Line points;
  for (int i = 0; i < 4000; ++i) {
    Eigen::Vector2d point = box.min() + part(rng) * box.sizes();
    const int axis = i % 2;
    point[axis] = (i % 4 < 2 ? box.min() : box.max())[axis] + across(rng);
    point[1 - axis] = box.min()[1 - axis] + part(rng) * box.sizes()[1 - axis];
    points.push_back(turn * point);
  }
  return points;
}

/** Ten points per pixel on a line. */
void
add(Line& points, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  const int count = static_cast<int>(10 * (to - from).norm());
  for (int i = 0; i <= count; ++i)
    points.push_back(from + (to - from) * i / count);
}

/** All that was seen is wall. */
FootprintWalls
behind(const Line& walls)
{
  FootprintWalls seen;
  seen.walls = seen.others = WallPoints(walls);
  return seen;
}

/** Walls of 40 x 30 pixels, and something before them that hangs. */
struct Hanging {
  Line walls, others;

  Hanging(const Line& ring)
  {
    const Line corners{{0, 0}, {40, 0}, {40, 30}, {0, 30}};
    for (int k = 0; k < 4; ++k)
      add(walls, corners[k], corners[(k + 1) % 4]);
    others = walls;
    for (std::size_t k = 0; k < ring.size(); ++k)
      add(others, ring[k], ring[(k + 1) % ring.size()]);
  }

  FootprintWalls
  seen(bool may_cover = true) const
  {
    FootprintWalls seen;
    seen.walls = WallPoints(walls);
    seen.others = WallPoints(others);
    seen.may_cover = [may_cover](const auto&) { return may_cover; };
    return seen;
  }
};

} // namespace

TEST(RoomFootprint, SidesMoveToTheirWalls)
{
  std::mt19937 rng(5);
  for (int degrees = 0; degrees < 90; degrees += 10) {
    const Eigen::AlignedBox2d box(Eigen::Vector2d(30.3, 4.6),
                                  Eigen::Vector2d(67.9, 27.2));
    const double yaw = degrees * M_PI / 180.0;
    const auto walls = wallsOf(box, 0.1, yaw, rng);
    auto map = emptyMap(120, 100);
    for (int x = 0; x < 120; ++x)
      for (int y = 0; y < 100; ++y) {
        const Eigen::Vector2d middle =
            Eigen::Rotation2Dd(-yaw) * Eigen::Vector2d(x + 0.5 - 40, y + 0.5);
        map.at(x, y) = box.contains(middle);
      }
    Line shifted = walls; // the map begins at x = -40
    for (auto& point : shifted) {
      point.x() += 40;
      const int x = static_cast<int>(point.x()), y = static_cast<int>(point.y());
      if (map.contains(x, y))
        map.at(x, y) = 0;
    }
    const auto ring = traceOutlines(map, 1)[1].at(0);
    const auto simple = simplifyOutline(ring, 1.5);
    const auto moved = moveToWalls(simple, behind(shifted));
    const double area = box.volume();
    EXPECT_LT(ringArea(simple), 0.97 * area) << degrees; // without the walls' pixels
    EXPECT_NEAR(ringArea(moved), area, 0.01 * area) << degrees;
    EXPECT_EQ(moved.size(), simple.size());
  }
}

TEST(RoomFootprint, SidesWithoutAWallStay)
{
  const Line ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_EQ(moveToWalls(ring, {}), ring);
  Line walls;
  for (int i = 0; i <= 100; ++i) {
    walls.emplace_back(10.5, 0.1 * i);         // behind the second side
    walls.emplace_back(0.1 * i, 13.0);         // too far behind the third one
    walls.emplace_back(-0.4, 4.5 + 0.001 * i); // a lot, but a short piece is a wall too
  }
  walls.emplace_back(5.0, -0.5); // a lone point
  const auto moved = moveToWalls(ring, behind(walls));
  const Line expected{{-0.4, 0}, {10.5, 0}, {10.5, 10}, {-0.4, 10}};
  ASSERT_EQ(moved.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_LT((moved[k] - expected[k]).norm(), 0.008); // half a bin along x and y
  EXPECT_NEAR(ringArea(moved), 109.0, 0.15);
  EXPECT_TRUE(moveToWalls({}, behind(walls)).empty());
}

TEST(RoomFootprint, AThinWallInARoomKeepsItsSides)
{
  const Line hole{{0, 0}, {0, 2}, {20, 2}, {20, 0}};
  ASSERT_LT(ringArea(hole), 0.0);
  Line walls;
  for (int i = 0; i <= 200; ++i) // two faces, both of them behind both long sides
    for (int k = 0; k < 5; ++k) {
      walls.emplace_back(0.1 * i, 0.2 + 0.02 * k);
      walls.emplace_back(0.1 * i, 1.8 - 0.02 * k);
    }
  EXPECT_LE(ringArea(moveToWalls(hole, behind(walls))), 0.0);
}

TEST(RoomFootprint, ASideThatIsSlightlyTurnedIsTurnedBack)
{
  Line walls;
  for (int i = 0; i <= 300; ++i)
    walls.emplace_back(0.1 * i, -0.2 - 0.04 * 0.1 * i); // falls by 1.2 pixels
  const Line ring{{0, 0}, {30, 0}, {30, 20}, {0, 20}};
  const auto moved = moveToWalls(ring, behind(walls));
  ASSERT_EQ(moved.size(), 4u);
  EXPECT_NEAR(moved[0].y(), -0.2, 0.05);
  EXPECT_NEAR(moved[1].y(), -1.4, 0.05);
  EXPECT_NEAR(ringArea(moved), 600.0 + 30 * 0.8, 1.0);
}

TEST(RoomFootprint, WhatHangsInACornerOrOnAWallIsLeftOut)
{
  const Line corner{{0, 0}, {30, 0}, {30, 4}, {40, 4}, {40, 30}, {0, 30}};
  const Line middle{
      {0, 0}, {12, 0}, {12, 4}, {28, 4}, {28, 0}, {40, 0}, {40, 30}, {0, 30}};
  for (const Line& ring : {corner, middle}) {
    const Hanging scene(ring);
    EXPECT_NEAR(ringArea(moveToWalls(ring, scene.seen())), 1200.0, 2.0);
    // not over another room
    EXPECT_NEAR(ringArea(moveToWalls(ring, scene.seen(false))), ringArea(ring), 2.0);
    // what stands is a wall
    FootprintWalls standing = scene.seen();
    standing.walls = standing.others;
    EXPECT_NEAR(ringArea(moveToWalls(ring, standing)), ringArea(ring), 2.0);
  }
}

TEST(RoomFootprint, WhatIsDeeperThanTheReachStays)
{
  const Line ring{{0, 0}, {25, 0}, {25, 14}, {40, 14}, {40, 30}, {0, 30}};
  FootprintWalls seen = Hanging(ring).seen();
  EXPECT_NEAR(ringArea(moveToWalls(ring, seen)), ringArea(ring), 2.0);
  seen.reach = 20.0;
  EXPECT_NEAR(ringArea(moveToWalls(ring, seen)), 1200.0, 2.0);
}

TEST(RoomFootprint, ALampIsNoHoleButAPillarIs)
{
  const Line hole{{10, 10}, {10, 16}, {16, 16}, {16, 10}};
  ASSERT_LT(ringArea(hole), 0.0);
  const Hanging scene(hole);
  EXPECT_TRUE(moveToWalls(hole, scene.seen()).empty());
  EXPECT_EQ(moveToWalls(hole, scene.seen(false)).size(), 4u); // a room within a room
  FootprintWalls pillar = scene.seen();
  pillar.walls = pillar.others;
  EXPECT_NEAR(ringArea(moveToWalls(hole, pillar)), -36.0, 0.5);
}
