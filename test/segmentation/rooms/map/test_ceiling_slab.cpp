/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/ceiling_slab.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl::indoor;
using Grid = VoxelMap<std::uint8_t>;

namespace {

Grid
emptyGrid(int nx, int ny, int nz)
{
  Grid grid;
  grid.shape = {nx, ny, nz};
  grid.voxel_size = 0.1;
  grid.values.assign(grid.shape.size(), 0);
  return grid;
}

void
fill(Grid& grid, int x0, int x1, int y0, int y1, int z0, int z1)
{
  for (int x = x0; x <= x1; ++x)
    for (int y = y0; y <= y1; ++y)
      for (int z = z0; z <= z1; ++z)
        grid.at(x, y, z) = 1;
}

/** A room of 3.8 m by 2.8 m with walls around it, floor in layer 1, ceiling in 26. */
Grid
boxRoom()
{
  Grid grid = emptyGrid(40, 30, 30);
  fill(grid, 0, 39, 0, 29, 1, 1);
  fill(grid, 0, 39, 0, 29, 26, 26);
  fill(grid, 0, 0, 0, 29, 1, 26);
  fill(grid, 39, 39, 0, 29, 1, 26);
  fill(grid, 0, 39, 0, 0, 1, 26);
  fill(grid, 0, 39, 29, 29, 1, 26);
  return grid;
}

int
highest(const Grid& grid, const VerticalRange& storey, int x, int y)
{
  for (int z = storey.end - 1; z >= storey.begin; --z)
    if (grid.at(x, y, z))
      return z;
  return -1;
}

Grid
randomGrid(std::mt19937& rng)
{
  Grid grid = emptyGrid(1 + rng() % 20, 1 + rng() % 20, 1 + rng() % 15);
  const unsigned sparsity = 2 + rng() % 60;
  for (auto& value : grid.values)
    value = rng() % sparsity == 0;
  return grid;
}

VerticalRange
randomRange(const Grid& grid, std::mt19937& rng)
{
  const int begin = rng() % grid.shape.nz;
  return {begin, begin + 1 + static_cast<int>(rng() % (grid.shape.nz - begin))};
}

bool
isWall(int x, int y)
{
  return x == 0 || x == 39 || y == 0 || y == 29;
}

} // namespace

TEST(CeilingSlab, AWindowLargerThanTheMapIsTheMap)
{
  const auto grid = boxRoom();
  CeilingSlabOptions whole, huge;
  whole.window = 2 * 40 * grid.voxel_size;
  huge.window = 1e9; // a row of so many voxels would not fit into memory
  const VerticalRange storey{0, 30};
  EXPECT_EQ(ceilingLayers(grid, storey, huge).values,
            ceilingLayers(grid, storey, whole).values);
  const auto ceiling = ceilingLayers(grid, storey, {});
  whole.max_gap = 30 * grid.voxel_size;
  huge.max_gap = 1e9;
  EXPECT_EQ(slabLayers(grid, storey, ceiling, huge).first,
            slabLayers(grid, storey, ceiling, whole).first);
}

TEST(CeilingLayers, EqualsBruteForce)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Grid grid = randomGrid(rng);
    const VerticalRange storey = randomRange(grid, rng);
    CeilingSlabOptions options;
    const int radius = rng() % 5, step = rng() % 8, headroom = rng() % 10;
    options.window = 0.2 * radius;
    options.step = 0.1 * step;
    options.min_height = 0.1 * headroom;
    options.level_share = 0.11 * static_cast<double>(rng() % 10);
    const auto ceiling = ceilingLayers(grid, storey, options);
    for (int x = 0; x < grid.shape.nx; ++x)
      for (int y = 0; y < grid.shape.ny; ++y) {
        const int own = highest(grid, storey, x, y);
        int expected = -1, all = 0, level = 0;
        for (int u = x - radius; u <= x + radius; ++u)
          for (int v = y - radius; v <= y + radius; ++v)
            if (grid.shape.contains(u, v, 0)) {
              expected = std::max(expected, highest(grid, storey, u, v));
              level += std::abs(highest(grid, storey, u, v) - own) <= 1;
              ++all;
            }
        const bool is_level = own >= storey.begin + headroom &&
                              level > options.level_share * static_cast<double>(all);
        if (own >= 0 && (own >= expected - step || is_level))
          expected = own;
        if (expected >= 0 && expected < storey.begin + headroom)
          expected = storey.end - 1;
        ASSERT_EQ(ceiling.at(x, y), expected) << "trial " << trial;
      }
  }
}

TEST(CeilingLayers, ALowCeilingBesideAHighOne)
{
  Grid grid = boxRoom();
  fill(grid, 20, 39, 0, 29, 19, 19); // 0.7 m lower: more than a step
  for (int x = 21; x < 40; ++x)      // nothing is seen above it
    for (int y = 0; y < 30; ++y)
      for (int z = 20; z <= 26; ++z)
        grid.at(x, y, z) = 0;
  const auto ceiling = ceilingLayers(grid, {0, 30}, {});
  for (int x = 0; x < 40; ++x)
    for (int y = 0; y < 30; ++y)
      ASSERT_EQ(ceiling.at(x, y), x <= 20 ? 26 : 19) << x << " " << y;
}

TEST(CeilingLayers, WithoutCeilingTheStoreyEndsIt)
{
  Grid grid = emptyGrid(20, 20, 30);
  fill(grid, 0, 19, 0, 19, 1, 1);
  fill(grid, 5, 9, 5, 9, 2, 9); // furniture is no ceiling
  for (const int layer : ceilingLayers(grid, {0, 27}, {}).values)
    ASSERT_EQ(layer, 26);
}

TEST(CeilingLayers, FlatCeilingWithHolesAndFurniture)
{
  Grid grid = boxRoom();
  fill(grid, 10, 19, 10, 17, 1, 8); // a table below ...
  for (int x = 12; x <= 16; ++x)    // ... a part of the ceiling that was not seen
    for (int y = 11; y <= 15; ++y)
      grid.at(x, y, 26) = 0;
  const auto ceiling = ceilingLayers(grid, {0, 30}, {});
  EXPECT_EQ(ceiling.values, std::vector<int>(ceiling.size(), 26));
}

TEST(CeilingLayers, UnseenFarFromAnythingIsNoCeiling)
{
  Grid grid = emptyGrid(40, 1, 10);
  grid.at(0, 0, 7) = 1;
  CeilingSlabOptions options;
  options.min_height = 0.5;
  const auto ceiling = ceilingLayers(grid, {0, 10}, options);
  for (int x = 0; x < 40; ++x) // the window reaches 5 voxels
    EXPECT_EQ(ceiling.at(x, 0), x <= 5 ? 7 : -1) << x;
}

TEST(CeilingLayers, FollowsASlopeAndNoise)
{
  std::mt19937 rng(2);
  Grid grid = emptyGrid(40, 30, 45);
  PixelMap<int> top{40, 30, {}};
  for (int x = 0; x < 40; ++x)
    for (int y = 0; y < 30; ++y) {
      const int z = 20 + x / 2 + static_cast<int>(rng() % 3); // 27 degrees
      fill(grid, x, x, y, y, 0, 0);
      grid.at(x, y, z) = 1;
      top.values.push_back(z);
    }
  EXPECT_EQ(ceilingLayers(grid, {0, 45}, {}).values, top.values);
}

TEST(CeilingLayers, OtherStoreysDoNotCount)
{
  Grid grid = boxRoom();
  fill(grid, 0, 39, 0, 29, 28, 29);
  for (const int layer : ceilingLayers(grid, {0, 27}, {}).values)
    ASSERT_EQ(layer, 26);
  for (const int layer : ceilingLayers(grid, {2, 20}, {}).values)
    ASSERT_TRUE(layer == 19 || layer == -1); // only walls
}

TEST(SlabLayers, LiesBelowTheBlurOfTheCeiling)
{
  for (int blur = 0; blur <= 8; ++blur) {
    Grid grid = boxRoom();
    fill(grid, 0, 39, 0, 29, 26 - blur, 26);
    const VerticalRange storey{0, 30};
    const auto ceiling = ceilingLayers(grid, storey, {});
    const auto slab = slabLayers(grid, storey, ceiling, {});
    // gap 0.15 m is at least two layers, max_gap 0.6 m at most six, depth 0.3 m three
    EXPECT_EQ(slab.first, std::clamp(blur + 1, 2, 6)) << "blur " << blur;
    EXPECT_EQ(slab.last, slab.first + 2) << "blur " << blur;
    if (blur > 5)
      continue;
    const auto blocked = blockedColumns(grid, storey, ceiling, slab);
    for (int x = 0; x < 40; ++x)
      for (int y = 0; y < 30; ++y)
        ASSERT_EQ(blocked.at(x, y), isWall(x, y)) << "blur " << blur;
  }
}

TEST(SlabLayers, FewNoisyVoxelsDoNotMoveIt)
{
  std::mt19937 rng(3);
  Grid grid = boxRoom();
  for (int i = 0; i < 15; ++i) // 1 % of the columns
    grid.at(rng() % 40, rng() % 30, 24) = 1;
  const auto ceiling = ceilingLayers(grid, {0, 30}, {});
  EXPECT_EQ(slabLayers(grid, {0, 30}, ceiling, {}).first, 2);
}

TEST(BlockedColumns, WallsAndWhatReachesTheCeilingButNoTablesAndCabinets)
{
  Grid grid = boxRoom();
  fill(grid, 10, 19, 10, 17, 1, 8);
  fill(grid, 20, 23, 5, 9, 1, 22); // free layers above it
  fill(grid, 30, 33, 5, 9, 1, 29);
  const VerticalRange storey{0, 30};
  const auto ceiling = ceilingLayers(grid, storey, {});
  const auto blocked =
      blockedColumns(grid, storey, ceiling, slabLayers(grid, storey, ceiling, {}));
  for (int x = 0; x < 40; ++x)
    for (int y = 0; y < 30; ++y)
      ASSERT_EQ(blocked.at(x, y),
                isWall(x, y) || (x >= 30 && x <= 33 && y >= 5 && y <= 9))
          << x << " " << y;
}

TEST(SeenTops, WallsThatAreSeenLessAboveTheHeadsAreLookedForBelow)
{
  const VerticalRange storey{1, 27};
  Grid grid = boxRoom();
  fill(grid, 20, 20, 1, 28, 1, 17); // a wall, seen to 1.6 m above the floor
  fill(grid, 10, 13, 10, 13, 1, 12);
  const auto ceiling = ceilingLayers(grid, storey, {});
  EXPECT_EQ(seenTops(grid, storey, ceiling, {}).values, ceiling.values); // most go on
  for (int z = 19; z < 26; ++z)
    for (int y = 0; y < 30; ++y)
      grid.at(39, y, z) = 0;
  const auto tops = seenTops(grid, storey, ceiling, {});
  EXPECT_EQ(tops.at(5, 5), 17);
  const auto blocked =
      blockedColumns(grid, storey, tops, slabLayers(grid, storey, tops, {}));
  EXPECT_EQ(blocked.at(20, 15), 1);
  EXPECT_EQ(blocked.at(39, 15), 1);
  EXPECT_EQ(blocked.at(11, 11), 0); // a table
}

TEST(SeenTops, OfLowStoreysAndCoarseVoxelsAreTheirCeilings)
{
  for (const double size : {0.1, 0.4, 1.0, 5.0})
    for (const int nz : {1, 2, 3, 12, 18, 19, 20, 21}) {
      Grid grid = emptyGrid(6, 6, nz);
      grid.voxel_size = size;
      fill(grid, 0, 0, 0, 5, 0, nz - 1);
      const auto ceiling = ceilingLayers(grid, {0, nz}, {});
      EXPECT_EQ(seenTops(grid, {0, nz}, ceiling, {}).values, ceiling.values) << nz;
    }
}

TEST(BlockedColumns, EqualsBruteForce)
{
  std::mt19937 rng(4);
  for (int trial = 0; trial < 100; ++trial) {
    const Grid grid = randomGrid(rng);
    const VerticalRange storey = randomRange(grid, rng);
    const auto ceiling = ceilingLayers(grid, storey, {});
    const int first = rng() % 5;
    const SlabLayers slab{first, first + static_cast<int>(rng() % 4)};
    const auto blocked = blockedColumns(grid, storey, ceiling, slab);
    for (int x = 0; x < grid.shape.nx; ++x)
      for (int y = 0; y < grid.shape.ny; ++y) {
        bool expected = false;
        for (int z = storey.begin; z < storey.end; ++z) {
          const int below = ceiling.at(x, y) - z;
          bool blocks = ceiling.at(x, y) >= 0 && below >= slab.first &&
                        below <= slab.last && grid.at(x, y, z);
          bool was_free = false;
          for (int w = z + 1; w < ceiling.at(x, y); ++w) {
            bool any = false;
            for (int u = x - 1; u <= x + 1; ++u)
              for (int v = y - 1; v <= y + 1; ++v)
                any = any || (grid.shape.contains(u, v, w) && grid.at(u, v, w));
            blocks = blocks && (any || !was_free);
            was_free = !any;
          }
          expected = expected || blocks;
        }
        ASSERT_EQ(blocked.at(x, y), expected) << "trial " << trial;
      }
  }
}

TEST(RemoveSpecks, EqualsBruteForceComponents)
{
  std::mt19937 rng(5);
  for (int trial = 0; trial < 100; ++trial) {
    PixelMap<std::uint8_t> blocked{
        1 + static_cast<int>(rng() % 14), 1 + static_cast<int>(rng() % 14), {}};
    const unsigned sparsity = 2 + rng() % 4;
    for (std::size_t i = 0; i < blocked.size(); ++i)
      blocked.values.push_back(rng() % sparsity == 0);
    const int extent = rng() % 6;

    const auto connected = [&](std::size_t a, std::size_t b) {
      const int ny = blocked.ny;
      const int i = static_cast<int>(a), k = static_cast<int>(b);
      return blocked.values[a] && blocked.values[b] && std::abs(i / ny - k / ny) <= 1 &&
             std::abs(i % ny - k % ny) <= 1;
    };
    std::vector<std::size_t> part(blocked.size());
    for (std::size_t i = 0; i < part.size(); ++i)
      part[i] = i;
    for (std::size_t a = 0; a < part.size(); ++a)
      for (std::size_t b = 0; b < part.size(); ++b)
        if (connected(a, b) && part[a] != part[b])
          std::replace(part.begin(), part.end(), std::size_t(part[b]), part[a]);
    auto expected = blocked;
    for (std::size_t i = 0; i < part.size(); ++i) {
      int low_x = 99, high_x = 0, low_y = 99, high_y = 0;
      for (std::size_t k = 0; k < part.size(); ++k)
        if (part[k] == part[i]) {
          low_x = std::min(low_x, static_cast<int>(k) / blocked.ny);
          high_x = std::max(high_x, static_cast<int>(k) / blocked.ny);
          low_y = std::min(low_y, static_cast<int>(k) % blocked.ny);
          high_y = std::max(high_y, static_cast<int>(k) % blocked.ny);
        }
      if (high_x - low_x + 1 < extent && high_y - low_y + 1 < extent)
        expected.values[i] = 0;
    }
    removeSpecks(blocked, extent);
    ASSERT_EQ(blocked.values, expected.values) << "trial " << trial;
  }
}

TEST(RemoveSpecks, EmptyMap)
{
  PixelMap<std::uint8_t> blocked;
  removeSpecks(blocked, 5);
  EXPECT_TRUE(blocked.values.empty());
}
