/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/interior_space.h"
#include "support/synthetic_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

/** Two wings that meet at a corner: free space in an L, exterior in the other corner of
 * the box around it. */
const std::vector<RoomBox> wings{{{0, 0, 0}, {8, 3, 2.5f}, 1},
                                 {{0, 3.1f, 0}, {3, 7, 2.5f}, 2}};

struct Built {
  std::vector<Eigen::Vector3f> points;
  OccupancyGrid building;
  InteriorSpace space;
};

Built
build(double yaw, int threads = 1)
{
  Built built;
  built.points = turned(rooms(wings, {}).points, yaw);
  OccupancyGridOptions options;
  options.voxel_size = 0.1;
  built.building = occupancyGrid(built.points, options);
  built.space = interiorSpace(built.building,
                              wallDirections(built.points, built.building, {}, threads),
                              {},
                              threads);
  return built;
}

/** Distance to the free space of the nearest wing; negative within. */
double
distanceToWings(const Eigen::Vector3d& point)
{
  double nearest = 99.0;
  for (const auto& wing : wings) {
    const Eigen::Array3d low = wing.low.cast<double>().array() - point.array();
    const Eigen::Array3d high = point.array() - wing.high.cast<double>().array();
    const Eigen::Array3d beyond = low.max(high);
    const double outside = beyond.max(0.0).matrix().norm();
    nearest = std::min(nearest, outside > 0 ? outside : beyond.maxCoeff());
  }
  return nearest;
}

} // namespace

class InteriorSpaceOfATurnedBuilding : public testing::TestWithParam<double> {};

TEST_P(InteriorSpaceOfATurnedBuilding, SeparatesInsideFromOutside)
{
  const double yaw = GetParam() * M_PI / 180;
  const auto built = build(yaw);
  const auto& space = built.space;
  EXPECT_EQ(space.factor, 2); // 0.2 m on a grid of 0.1 m
  EXPECT_NEAR(space.inside.voxel_size, 0.2, 1e-12);
  // A voxel at least half its diagonal from a surface does not touch it.
  const double clearance = 0.5 * std::sqrt(3.0) * 0.2 + 0.01;
  const Eigen::AngleAxisd back(-yaw, Eigen::Vector3d::UnitZ());
  std::size_t inside = 0, outside = 0, wrong_inside = 0, wrong_outside = 0;
  const auto& shape = space.inside.shape;
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y)
      for (int z = 0; z < shape.nz; ++z) {
        const Eigen::Vector3d center = space.inside.center(x, y, z);
        const double distance =
            distanceToWings(back * built.building.toBuilding(center));
        const bool is_inside = space.inside.at(x, y, z);
        inside += distance < -clearance;
        outside += distance > clearance;
        wrong_inside += distance > clearance && is_inside;
        wrong_outside += distance < -clearance && !is_inside;
        ASSERT_FALSE(is_inside && space.occupancy.at(x, y, z));
      }
  EXPECT_GT(inside, 2000u);
  EXPECT_GT(outside, 2000u);
  EXPECT_EQ(wrong_outside, 0u);
  EXPECT_EQ(wrong_inside, 0u);
}

TEST_P(InteriorSpaceOfATurnedBuilding, FindsTheDirectionsOfTheWalls)
{
  const double yaw = GetParam() * M_PI / 180;
  const auto built = build(yaw);
  ASSERT_GE(built.space.directions.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& direction = built.space.directions[i];
    // off the walls by at most one degree
    EXPECT_NEAR(std::remainder(std::atan2(direction.y(), direction.x()) - yaw, M_PI_2),
                0.0,
                M_PI / 180);
  }
  EXPECT_NEAR(built.space.directions[0].dot(built.space.directions[1]), 0.0, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Yaw,
                         InteriorSpaceOfATurnedBuilding,
                         testing::Values(0.0, 17.0, 30.0, 45.0));

TEST(InteriorSpace, TheNumberOfThreadsChangesNothing)
{
  const auto one = build(0.3, 1), two = build(0.3, 2);
  EXPECT_EQ(one.space.inside.bytes().values, two.space.inside.bytes().values);
  EXPECT_EQ(one.space.occupancy.bytes().values, two.space.occupancy.bytes().values);
}

TEST(InteriorSpace, CoarseVoxelsKeepTheirPlace)
{
  const auto built = build(0.0);
  const auto& grid = built.building.grid;
  const auto& coarse = built.space.inside;
  EXPECT_EQ(coarse.origin, grid.origin);
  EXPECT_EQ(coarse.shape.nx, (grid.shape.nx + 1) / 2);
  EXPECT_EQ(coarse.shape.ny, (grid.shape.ny + 1) / 2);
  EXPECT_EQ(coarse.shape.nz, (grid.shape.nz + 1) / 2);
}

TEST(InteriorSpace, AFloorAloneHasNoInterior)
{
  std::mt19937 rng(3);
  LabelledPoints floor;
  floor.addRectangle({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 1}, 1, 0.05f, 0.0f, rng);
  const auto building = occupancyGrid(floor.points, {});
  const auto space = interiorSpace(building, wallDirections(floor.points, building));
  EXPECT_EQ(space.inside.count(), 0u);
}

TEST(InteriorSpace, NoPointsGiveAnEmptySpace)
{
  const auto space = interiorSpace(occupancyGrid({}, {}), {}, {});
  EXPECT_TRUE(space.inside.empty());
}
