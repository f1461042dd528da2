/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/vertical_cleanup.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

using namespace pcl::indoor;

namespace {

/** \brief A grid with one column, from a picture: # is occupied, the left end lowest.
 */
VoxelMap<std::uint8_t>
columnGrid(const std::string& picture)
{
  VoxelMap<std::uint8_t> grid;
  grid.shape = {1, 1, static_cast<int>(picture.size())};
  for (const char c : picture)
    grid.values.push_back(c == '#');
  return grid;
}

std::string
cleaned(const std::string& picture)
{
  auto grid = columnGrid(picture);
  cleanUpVertically(grid);
  std::string result;
  for (const auto value : grid.values)
    result += value ? '#' : '.';
  return result;
}

/** \brief The definition, voxel by voxel: it is a run of one, and free voxels
 * and then occupied ones follow on both sides.
 */
std::uint8_t
cleanedVoxel(const VoxelMap<std::uint8_t>& grid, int x, int y, int z)
{
  if (!grid.at(x, y, z))
    return 0;
  int low = z;
  int high = z;
  while (low > 0 && grid.at(x, y, low - 1))
    --low;
  while (high + 1 < grid.shape.nz && grid.at(x, y, high + 1))
    ++high;
  bool below = false;
  bool above = false;
  for (int other = 0; other < low; ++other)
    below = below || grid.at(x, y, other);
  for (int other = high + 1; other < grid.shape.nz; ++other)
    above = above || grid.at(x, y, other);
  return !(below && above && high == low);
}

} // namespace

TEST(CleanUpVertically, FreesTheMiddleOfThePattern)
{
  EXPECT_EQ(cleaned("#..#..#"), "#.....#");
  EXPECT_EQ(cleaned("#.#.#.#"), "#.....#");
  EXPECT_EQ(cleaned("##.#.##"), "##...##");
  EXPECT_EQ(cleaned("..#.#.#.."), "..#...#..");
}

TEST(CleanUpVertically, KeepsEndsAndLongRuns)
{
  EXPECT_EQ(cleaned("#..#..."), "#..#...");
  EXPECT_EQ(cleaned("...#..."), "...#...");
  EXPECT_EQ(cleaned("#.##.#"), "#.##.#");
  EXPECT_EQ(cleaned(""), "");
}

TEST(CleanUpVertically, EqualsTheDefinition)
{
  std::mt19937 rng(7);
  for (int trial = 0; trial < 200; ++trial) {
    VoxelMap<std::uint8_t> grid;
    grid.shape = {3, 4, 1 + static_cast<int>(rng() % 16)};
    const unsigned share = 1 + rng() % 4;
    for (std::size_t v = 0; v < grid.shape.size(); ++v)
      grid.values.push_back(rng() % (share + 1) == 0 ? 1 + rng() % 9 : 0);
    const auto before = grid;
    cleanUpVertically(grid, 1 + trial % 3);
    for (int x = 0; x < grid.shape.nx; ++x)
      for (int y = 0; y < grid.shape.ny; ++y)
        for (int z = 0; z < grid.shape.nz; ++z)
          ASSERT_EQ(grid.at(x, y, z) != 0, cleanedVoxel(before, x, y, z))
              << "trial " << trial;
  }
}

TEST(CleanUpVertically, RefusesBadArguments)
{
  auto grid = columnGrid("#.#.#");
  EXPECT_THROW(cleanUpVertically(grid, -1), pcl::BadArgumentException);
  grid.values.pop_back();
  EXPECT_THROW(cleanUpVertically(grid), pcl::BadArgumentException);
}
