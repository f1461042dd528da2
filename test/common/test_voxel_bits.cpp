/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/indoor/voxel_bits.h>

#include "support/bits_of.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace pcl::indoor;

namespace {

/** \brief Seldom a multiple of a word high; no column, one voxel, many words. */
VoxelMap<std::uint8_t>
randomMap(std::mt19937& rng)
{
  VoxelMap<std::uint8_t> map;
  const auto side = [&](unsigned most) { return static_cast<int>(rng() % most); };
  map.shape = {side(5), 1 + side(5), 1 + side(200)};
  map.origin = {1.0, -2.0, 0.5};
  map.voxel_size = 0.1;
  const unsigned rare = 1 + rng() % 40;
  for (std::size_t v = 0; v < map.shape.size(); ++v)
    map.values.push_back(rng() % rare == 0 ? 1 + rng() % 255 : 0);
  return map;
}

} // namespace

TEST(VoxelBits, EqualsBytes)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 100; ++trial) {
    const auto map = randomMap(rng);
    const VoxelBits bits = map;
    ASSERT_EQ(bits.shape, map.shape);
    EXPECT_EQ(bits.origin, map.origin);
    EXPECT_EQ(bits.voxel_size, map.voxel_size);
    EXPECT_EQ(bits.empty(), map.values.empty());
    std::size_t count = 0;
    for (int x = 0; x < map.shape.nx; ++x)
      for (int y = 0; y < map.shape.ny; ++y)
        for (int z = 0; z < map.shape.nz; ++z) {
          ASSERT_EQ(bits.at(x, y, z), map.at(x, y, z) != 0) << trial;
          count += bits.at(x, y, z);
        }
    EXPECT_EQ(bits.count(), count);
    const auto bytes = bits.bytes();
    EXPECT_EQ(bytes.shape, map.shape);
    EXPECT_EQ(bytes.origin, map.origin);
    EXPECT_EQ(bytes.voxel_size, map.voxel_size);
    EXPECT_TRUE(std::equal(bytes.values.begin(),
                           bytes.values.end(),
                           map.values.begin(),
                           map.values.end(),
                           [](auto bit, auto value) { return bit == (value != 0); }));
  }
}

TEST(VoxelBits, AnyOfAColumnEqualsLookingAtEach)
{
  std::mt19937 rng(2);
  for (int trial = 0; trial < 100; ++trial) {
    const auto map = randomMap(rng);
    const VoxelBits bits = map;
    for (std::size_t pixel = 0; pixel < bits.columns(); ++pixel)
      for (int k = 0; k < 50; ++k) {
        const int begin = static_cast<int>(rng() % (map.shape.nz + 1));
        const int end = static_cast<int>(rng() % (map.shape.nz + 1));
        bool any = false;
        for (int z = begin; z < end; ++z)
          any |= map.values[pixel * map.shape.nz + z] != 0;
        ASSERT_EQ(bits.column(pixel).any(begin, end), any) << begin << " " << end;
      }
  }
}

TEST(VoxelBits, LowestAndHighestAreThoseOfAllLayersLookedAt)
{
  std::mt19937 rng(3);
  for (int trial = 0; trial < 300; ++trial) {
    const auto map = randomMap(rng);
    if (map.values.empty())
      continue;
    const VoxelBits bits = map;
    const int begin = static_cast<int>(rng() % map.shape.nz);
    const int end = begin + static_cast<int>(rng() % (map.shape.nz - begin + 1));
    int lowest = end, highest = begin - 1;
    for (int z = begin; z < end; ++z)
      if (map.at(0, 0, z)) {
        lowest = std::min(lowest, z);
        highest = z;
      }
    EXPECT_EQ(bits.column(0).lowest(begin, end), lowest) << "trial " << trial;
    EXPECT_EQ(bits.column(0).highest(begin, end), highest) << "trial " << trial;
  }
}

TEST(VoxelBits, SetByManyThreadsAndCleared)
{
  constexpr int nz = 70;
  VoxelBits bits;
  bits.reset({3, 4, nz});
#pragma omp parallel for num_threads(8)
  for (int i = 0; i < 12 * nz; ++i) // neighbours in a word, each by another thread
    if (i % 3 == 0)
      bits.set(i % 3, i / 3 % 4, i / 12);
  EXPECT_EQ(bits.count(), 4u * nz);
  bits.clearColumn(1);
  EXPECT_EQ(bits.count(), 3u * nz);
  EXPECT_FALSE(bits.column(0, 1).any(0, nz));
  EXPECT_TRUE(bits.column(0, 2).any(0, nz));
  VoxelBits other;
  other.reset(bits.shape);
  EXPECT_NE(bitsOf(other), bitsOf(bits));
  bits.reset(bits.shape);
  EXPECT_EQ(bitsOf(other), bitsOf(bits));
}

TEST(VoxelBits, RefusesMapsThatAreNotFilled)
{
  VoxelMap<std::uint8_t> map;
  map.shape = {2, 2, 2};
  EXPECT_THROW(VoxelBits{map}, pcl::BadArgumentException);
  EXPECT_TRUE(VoxelBits().empty());
}
