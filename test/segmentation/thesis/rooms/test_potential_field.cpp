/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "thesis/rooms/potential_field.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using pcl::indoor::kNoObstacle;
using pcl::indoor::VoxelMap;

namespace {

VoxelMap<std::uint8_t>
randomGrid(int nx, int ny, int nz, unsigned sparsity, std::mt19937& rng)
{
  VoxelMap<std::uint8_t> grid;
  grid.shape = {nx, ny, nz};
  grid.voxel_size = 0.2;
  grid.values.resize(grid.shape.size());
  for (auto& value : grid.values)
    value = rng() % sparsity == 0;
  return grid;
}

std::vector<std::uint32_t>
fieldBruteForce(const VoxelMap<std::uint8_t>& grid)
{
  const auto& s = grid.shape;
  std::vector<std::uint32_t> field(s.size(), kNoObstacle);
  for (int x = 0; x < s.nx; ++x)
    for (int y = 0; y < s.ny; ++y)
      for (int z = 0; z < s.nz; ++z)
        for (int u = 0; u < s.nx; ++u)
          for (int v = 0; v < s.ny; ++v)
            for (int w = z; w < s.nz; ++w)
              if (grid.at(u, v, w)) {
                const int d = (u - x) * (u - x) + (v - y) * (v - y) + (w - z) * (w - z);
                auto& best = field[s.index(x, y, z)];
                best = std::min(best, static_cast<std::uint32_t>(d));
              }
  return field;
}

} // namespace

TEST(PotentialField, EqualsBruteForce)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 150; ++trial) {
    const int nx = 1 + rng() % 19, ny = 1 + rng() % 19, nz = 1 + rng() % 7;
    const auto grid = randomGrid(nx, ny, nz, 1 + rng() % 400, rng);
    const auto field = pcl::indoor::potentialField(grid);
    EXPECT_EQ(field.values, fieldBruteForce(grid)) << "trial " << trial;
    EXPECT_EQ(field.shape, grid.shape);
    EXPECT_EQ(field.voxel_size, grid.voxel_size);
  }
}

TEST(PotentialField, IgnoresWhatLiesBelow)
{
  std::mt19937 rng(1);
  auto grid = randomGrid(5, 5, 6, 1, rng);
  std::fill(grid.values.begin(), grid.values.end(), std::uint8_t{0});
  grid.at(2, 2, 1) = 1; // a table
  auto field = pcl::indoor::potentialField(grid);
  EXPECT_EQ(field.at(2, 2, 2), kNoObstacle);
  EXPECT_EQ(field.at(2, 2, 0), 1u);
  EXPECT_EQ(field.at(0, 2, 1), 4u);
  grid.at(2, 2, 5) = 1; // a ceiling
  field = pcl::indoor::potentialField(grid);
  EXPECT_EQ(field.at(2, 2, 2), 9u);
}

TEST(PotentialField, DoesNotDependOnThreads)
{
  std::mt19937 rng(2);
  const auto grid = randomGrid(61, 47, 13, 900, rng);
  EXPECT_EQ(pcl::indoor::potentialField(grid, 1).values,
            pcl::indoor::potentialField(grid, 8).values);
}

TEST(PotentialField, EmptyGridGivesEmptyField)
{
  EXPECT_TRUE(pcl::indoor::potentialField(VoxelMap<std::uint8_t>{}).values.empty());
}

TEST(FieldMap, TakesTheLargestInteriorValue)
{
  VoxelMap<std::uint32_t> field;
  field.shape = {1, 3, 3};
  field.values = {7, 9, 4, kNoObstacle, 5, 6, 1, 2, 3};
  VoxelMap<std::uint8_t> interior;
  interior.shape = field.shape;
  interior.values = {1, 0, 1, 1, 1, 0, 0, 0, 0};
  EXPECT_EQ(pcl::indoor::fieldMap(field, interior).values,
            (std::vector<float>{7.0f, 5.0f, 0.0f}));
  EXPECT_EQ(pcl::indoor::highestFreeVoxel(interior).values,
            (std::vector<int>{2, 1, -1}));
  interior.shape.nz = 2;
  EXPECT_THROW(pcl::indoor::fieldMap(field, interior), pcl::BadArgumentException);
}
