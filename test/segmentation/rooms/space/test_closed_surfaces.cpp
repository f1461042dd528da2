/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/closed_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace pcl::indoor;

namespace {

/** A level plane of 64 x 64 voxels with a share of them occupied. */
VoxelMap<std::uint8_t>
plane(double share, std::mt19937& rng)
{
  VoxelMap<std::uint8_t> grid;
  grid.voxel_size = 0.1;
  grid.shape = {64, 64, 8};
  grid.values.assign(grid.shape.size(), 0);
  for (int x = 0; x < 64; ++x)
    for (int y = 0; y < 64; ++y)
      grid.values[grid.shape.index(x, y, 4)] = rng() % 100000 < 100000 * share;
  return grid;
}

} // namespace

TEST(ClosedVoxelSize, DenseSurfacesKeepTheirSize)
{
  std::mt19937 rng(1);
  EXPECT_EQ(closedVoxelSize(plane(1.0, rng), 0.4), 0.1);
  EXPECT_EQ(closedVoxelSize(plane(0.8, rng), 0.4), 0.1);
  EXPECT_EQ(closedVoxelSize({}, 0.4), VoxelMap<std::uint8_t>().voxel_size);
}

TEST(ClosedVoxelSize, RisesAsPointsOfTheSameDensityDemand)
{
  // n points per voxel at random occupy 1 - exp(-n) of the voxels; three of four voxels
  // under one twice as large are occupied at n = 1.37, and n rises with the square.
  std::mt19937 rng(2);
  for (const double n : {0.2, 0.3, 0.5, 0.8}) {
    const double size = closedVoxelSize(plane(1.0 - std::exp(-n), rng), 0.4);
    const double expected = 0.1 * std::sqrt(1.37 / n);
    EXPECT_NEAR(size, expected, 0.15 * expected) << n; // read between octaves
  }
}

TEST(ClosedVoxelSize, HasALimit)
{
  std::mt19937 rng(3);
  EXPECT_EQ(closedVoxelSize(plane(0.001, rng), 0.4), 0.4);
  EXPECT_EQ(closedVoxelSize(plane(0.001, rng), 0.05), 0.1);
}

TEST(HasHoles, WhereVoxelsHaveFewNeighbors)
{
  std::mt19937 rng(4);
  EXPECT_FALSE(hasHoles(plane(1.0, rng)));
  EXPECT_FALSE(hasHoles(plane(0.95, rng)));
  EXPECT_TRUE(hasHoles(plane(0.5, rng)));
  EXPECT_TRUE(hasHoles(plane(0.05, rng)));
  EXPECT_FALSE(hasHoles({}));

  VoxelMap<std::uint8_t> rings = plane(0.0, rng); // as of a lidar: lines, 0.3 m apart
  for (int x = 0; x < 64; x += 3)
    for (int y = 0; y < 64; ++y)
      rings.values[rings.shape.index(x, y, 4)] = 1;
  EXPECT_TRUE(hasHoles(rings));
}

TEST(HasHoles, AFewObjectsInAirAreNone)
{
  std::mt19937 rng(5);
  VoxelMap<std::uint8_t> grid = plane(1.0, rng);
  for (int x = 2; x < 64; x += 8)
    for (int y = 2; y < 64; y += 8)
      grid.values[grid.shape.index(x, y, 1)] = 1; // 64 of 4160 voxels
  EXPECT_FALSE(hasHoles(grid));
}
