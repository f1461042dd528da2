/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/wall_lean.h"
#include <pcl/segmentation/building_rooms.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl::indoor;

namespace {

constexpr double degree = M_PI / 180.0;
constexpr double voxel = 0.1; // metres
constexpr int top = 27;       // layer of the ceiling, the floor is layer 0
const SlabLayers slab{2, 4};

/** A floor, a ceiling and the two faces of a wall that leans, as voxels. */
struct Section {
  VoxelMap<std::uint8_t> occupancy;
  PixelMap<int> ceiling;
  PixelMap<std::uint8_t> blocked;
  Eigen::Vector2d normal;

  Section(double yaw, double lean, double thickness = 0.2)
  : normal(std::cos(yaw), std::sin(yaw))
  {
    occupancy.shape = {60, 60, top + 1};
    occupancy.voxel_size = voxel;
    occupancy.values.assign(occupancy.shape.size(), 0);
    ceiling = {60, 60, std::vector<int>(3600, top)};
    blocked = {60, 60, std::vector<std::uint8_t>(3600, 0)};
    const Eigen::Vector2d along(-normal.y(), normal.x());
    for (double s = -2.5; s < 2.5; s += 0.02)
      for (double z = 0.0; z < 2.8; z += 0.02)
        for (const double face : {-0.5 * thickness, 0.5 * thickness}) {
          const Eigen::Vector2d place = // metres; deeper is farther along the normal
              Eigen::Vector2d(3.02, 3.04) + s * along +
              (face + (2.4 - z) * std::tan(lean)) * normal;
          fill(place, z);
        }
    for (int x = 0; x < 60; ++x)
      for (int y = 0; y < 60; ++y) {
        occupancy.at(x, y, 0) = occupancy.at(x, y, top) = 1;
        for (int z = top - slab.last; z <= top - slab.first; ++z)
          blocked.at(x, y) |= occupancy.at(x, y, z);
      }
  }

  void
  fill(const Eigen::Vector2d& place, double z)
  {
    const int x = static_cast<int>(std::floor(place.x() / voxel));
    const int y = static_cast<int>(std::floor(place.y() / voxel));
    if (occupancy.shape.contains(x, y, static_cast<int>(z / voxel)))
      occupancy.at(x, y, static_cast<int>(z / voxel)) = 1;
  }

  std::vector<WallStretch>
  stretches(int threads = 0) const
  {
    RoomMap storey;
    storey.range = {0, top + 1};
    storey.ceiling = ceiling;
    storey.slab = slab;
    storey.blocked = blocked;
    return wallStretches(occupancy, storey, threads);
  }

  PixelMap<Eigen::Vector2f>
  map() const
  {
    return leanMap(stretches(), 60, 60, voxel);
  }
};

/** Two rooms of 4 m x 5 m beside each other with a door, all leaning towards a heading,
 * the points of their surfaces and the room of each. */
struct TwoRooms {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::uint32_t> truth;

  TwoRooms(double lean, double heading)
  {
    std::mt19937 rng(3);
    const auto noise = [&] {
      return 0.00001 * (static_cast<double>(rng() % 2001) - 1000);
    };
    const Eigen::Vector2d shift =
        std::tan(lean) * Eigen::Vector2d(std::cos(heading), std::sin(heading));
    const auto add = [&](double x, double y, double z, std::uint32_t room) {
      const Eigen::Vector3d point(
          x + noise() + shift.x() * z, y + noise() + shift.y() * z, z + noise());
      points.push_back(point.cast<float>());
      truth.push_back(room);
    };
    constexpr double step = 0.04, height = 2.6;
    for (const int room : {0, 1}) {
      const double x0 = 4.12 * room, x1 = x0 + 4.0;
      for (double x = x0; x <= x1; x += step) {
        for (double y = 0.0; y <= 5.0; y += step) {
          add(x, y, 0.0, room + 1);
          add(x, y, height, room + 1);
        }
        for (double z = 0.0; z < height; z += step) {
          add(x, 0.0, z, room + 1);
          add(x, 5.0, z, room + 1);
        }
      }
      for (double y = 0.0; y <= 5.0; y += step)
        for (double z = 0.0; z < height; z += step)
          for (const double x : {x0, x1})
            if (!((room == 0) == (x == x1) && y > 3.0 && y < 3.9 && z < 2.0)) // door
              add(x, y, z, room + 1);
    }
  }

  double
  rightShare(const std::vector<std::uint32_t>& labels) const
  {
    std::size_t same = 0, swapped = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      same += labels[i] == truth[i];
      swapped += labels[i] == 3 - truth[i];
    }
    return static_cast<double>(std::max(same, swapped)) /
           static_cast<double>(labels.size());
  }
};

} // namespace

TEST(WallLean, IsThatOfTheWall)
{
  for (const double yaw : {0.0, 20.0, 45.0, 90.0, 130.0})
    for (const double lean : {-20.0, -10.0, 5.0, 10.0, 20.0}) {
      const Section section(yaw * degree, lean * degree);
      const auto found = section.stretches();
      EXPECT_GE(found.size(), 5u);
      for (const auto& wall : found) {
        const double cosine = wall.normal.dot(section.normal);
        if (std::abs(cosine) < 0.98)
          continue; // where the wall ends
        // A voxel over the height of 2.2 m is 0.045.
        EXPECT_NEAR(std::copysign(wall.lean, cosine * wall.lean),
                    std::tan(lean * degree),
                    0.045)
            << yaw << " degrees, leaning " << lean;
      }
    }
}

TEST(WallLean, UprightWallsHaveNone)
{
  for (const double yaw : {0.0, 20.0, 45.0, 90.0})
    for (const double thickness : {0.0, 0.1, 0.2, 0.3}) {
      const Section section(yaw * degree, 0.0, thickness);
      EXPECT_GE(section.stretches().size(), 5u);
      EXPECT_TRUE(section.map().values.empty()) << yaw << ", " << thickness;
    }
}

TEST(WallLean, FurnitureDoesNotMatter)
{
  Section section(0.0, 10 * degree);
  for (double y = 1.5; y < 4.5; y += 0.05) // an upright front of 1.8 m before the wall
    for (double z = 0.0; z < 1.8; z += 0.05)
      section.fill({2.4, y}, z);
  const auto map = section.map();
  ASSERT_FALSE(map.values.empty());
  for (int y = 15; y < 45; ++y)
    EXPECT_NEAR(map.at(31, y).x(), std::tan(10 * degree), 0.02);
}

TEST(WallLean, ALintelIsNoWall)
{
  Section section(0.0, 10 * degree);
  for (std::size_t i = 0; i < section.occupancy.values.size(); ++i)
    if (const std::size_t z = i % (top + 1); z > 0 && z < 20)
      section.occupancy.values[i] = 0;
  EXPECT_TRUE(section.stretches().empty());
}

TEST(WallLean, DoesNotDependOnThreads)
{
  const Section section(20 * degree, 10 * degree);
  const auto one = section.stretches(1), four = section.stretches(4);
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].place, four[i].place);
    EXPECT_EQ(one[i].lean, four[i].lean);
  }
}

TEST(WallLean, TwoWallsTellTheShiftAtTheirCorner)
{
  std::vector<WallStretch> walls;
  for (int i = 0; i < 10; ++i) {
    walls.push_back({{20.0, 20.0 + 5 * i}, {1, 0}, 0.3, 1e4});
    walls.push_back({{20.0 + 5 * i, 20.0}, {0, -1}, 0.2, 1e4});
  }
  const auto map = leanMap(walls, 80, 80, voxel);
  ASSERT_FALSE(map.values.empty());
  EXPECT_NEAR(map.at(21, 21).x(), 0.3, 0.01);
  EXPECT_NEAR(map.at(21, 21).y(), -0.2, 0.01);
  EXPECT_NEAR(map.at(20, 60).x(), 0.3, 0.01);
  EXPECT_NEAR(map.at(20, 60).y(), 0.0, 0.01); // one wall does not tell this
  EXPECT_EQ(map.at(60, 60).norm(), 0.0f);     // nothing near
}

TEST(WallLean, WhatFewSayDoesNotCount)
{
  std::vector<WallStretch> walls;
  for (int i = 0; i < 10; ++i)
    walls.push_back({{20.0, 20.0 + 5 * i}, {1, 0}, i == 5 ? 0.3 : 0.0, 1e4});
  EXPECT_TRUE(leanMap(walls, 80, 80, voxel).values.empty());
  for (auto& wall : walls)
    wall.lean = 0.3 - wall.lean;
  const auto map = leanMap(walls, 80, 80, voxel);
  ASSERT_FALSE(map.values.empty());
  for (int y = 20; y < 60; ++y)
    EXPECT_NEAR(map.at(20, y).x(), 0.3, 0.03);
  EXPECT_TRUE(leanMap({}, 80, 80, voxel).values.empty());
}

TEST(WallLean, StraightenedUndoesAShear)
{
  const PixelMap<Eigen::Vector2f> lean{
      50, 50, std::vector<Eigen::Vector2f>(2500, {0.25f, -0.5f})};
  const PixelMap<float> height{50, 50, std::vector<float>(2500, 24.5f)};
  const Eigen::Vector2d straight =
      straightened(lean, height, {20.0 + 0.25 * 16, 30.0 - 0.5 * 16, 8.5});
  EXPECT_NEAR(straight.x(), 20.0, 1e-9);
  EXPECT_NEAR(straight.y(), 30.0, 1e-9);
}

TEST(WallLean, PointsGetTheRoomBetweenLeaningWalls)
{
  for (const double lean : {0.0, 5.0, 10.0, 20.0})
    for (const double heading : {0.0, 45.0, 90.0}) {
      const TwoRooms scene(lean * degree, heading * degree);
      const auto building = segmentBuilding(scene.points);
      EXPECT_EQ(building.rooms.size(), 2u) << lean << " towards " << heading;
      // A lean of a degree too little or too much moves the wall of 0.12 m by 4 cm.
      EXPECT_GT(scene.rightShare(building.point_labels), lean > 0 ? 0.97 : 0.99)
          << lean << " towards " << heading;
    }
}

TEST(WallLean, LeaningWallsHeadWhereUprightOnesDo)
{
  for (const double heading : {0.0, 10.0, 20.0, 27.0, 45.0}) {
    const TwoRooms scene(20 * degree, heading * degree);
    const auto directions = wallDirections(scene.points, occupancyGrid(scene.points));
    ASSERT_GE(directions.size(), 2u);
    for (const auto& direction : {directions[0], directions[1]})
      EXPECT_GT(direction.cwiseAbs().maxCoeff(), std::cos(0.5 * degree)) << heading;
  }
}

TEST(WallLean, LabelsDependNeitherOnThreadsNorOnOrder)
{
  TwoRooms scene(10 * degree, 30 * degree);
  BuildingRoomsOptions options;
  options.threads = 1;
  const auto one = segmentBuilding(scene.points, options);
  options.threads = 4;
  EXPECT_EQ(one.point_labels, segmentBuilding(scene.points, options).point_labels);
  std::vector<std::size_t> order(scene.points.size());
  std::mt19937 rng(1);
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
    std::swap(order[i], order[rng() % (i + 1)]);
  }
  std::vector<Eigen::Vector3f> shuffled;
  for (const std::size_t i : order)
    shuffled.push_back(scene.points[i]);
  const auto other = segmentBuilding(shuffled, options);
  std::size_t same = 0;
  for (std::size_t k = 0; k < order.size(); ++k)
    same += other.point_labels[k] == one.point_labels[order[k]];
  EXPECT_EQ(same, order.size());
}
