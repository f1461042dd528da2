/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/block_extent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <tuple>
#include <vector>

using namespace pcl::indoor;

namespace {

using Points = std::vector<Eigen::Vector3f>;
using Block = std::array<int, 3>;

/** A point in the middle of a block. */
void
addBlock(int x, int y, int z, Points& points)
{
  points.emplace_back(x + 0.5f, y + 0.5f, z + 0.5f);
}

struct Part {
  std::size_t points = 0;
  double blocks = 0;
  Eigen::Array3d low = Eigen::Array3d::Constant(1e9), high = -low;
};

/** Blocks that touch, the lowest block's part first. */
std::vector<Part>
partsOf(const Points& points)
{
  std::map<Block, std::size_t> counts;
  for (const auto& point : points)
    ++counts[{static_cast<int>(std::floor(point.x())),
              static_cast<int>(std::floor(point.y())),
              static_cast<int>(std::floor(point.z()))}];
  std::vector<Part> parts;
  while (!counts.empty()) {
    parts.emplace_back();
    std::vector<Block> open{counts.begin()->first};
    while (!open.empty()) {
      const auto block = open.back();
      open.pop_back();
      const auto found = counts.find(block);
      if (found == counts.end())
        continue;
      auto& part = parts.back();
      const Eigen::Array3d low(block[0], block[1], block[2]);
      part.points += found->second;
      part.blocks += 1;
      part.low = part.low.min(low);
      part.high = part.high.max(low + 1);
      counts.erase(found);
      for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
          for (int z = -1; z <= 1; ++z)
            open.push_back({block[0] + x, block[1] + y, block[2] + z});
    }
  }
  return parts;
}

/** Parts are asked in turn, the largest first, until the box takes none of them. */
Part
boxOf(std::vector<Part> parts)
{
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
    return a.points > b.points;
  });
  Part box = parts.front();
  std::vector<bool> is_taken(parts.size(), false);
  is_taken[0] = true;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t p = 1; p < parts.size(); ++p) {
      const Eigen::Array3d low = box.low.min(parts[p].low),
                           high = box.high.max(parts[p].high);
      if (is_taken[p] || (high - low).prod() - (box.high - box.low).prod() >
                             most_growth * parts[p].blocks)
        continue;
      box.low = low;
      box.high = high;
      is_taken[p] = changed = true;
    }
  }
  return box;
}

void
expectBox(const Points& points)
{
  const auto expected = boxOf(partsOf(points));
  const auto box = blockExtent(points, 1);
  EXPECT_EQ(box.low, Eigen::Vector3d(expected.low.matrix().array() - 0.5));
  EXPECT_EQ(box.high, Eigen::Vector3d(expected.high.matrix().array() + 0.5));
}

} // namespace

TEST(BlockExtent, TakesPartsThatAreWorthTheirSpace)
{
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 rng(seed);
    Points points;
    const int size = 3 + static_cast<int>(rng() % 12);
    const int apart = 1 + static_cast<int>(seed % 25); // along x
    const auto random = [&] { return static_cast<int>(rng() % size); };
    for (unsigned i = 0; i < 4 + seed / 4; ++i)
      addBlock(apart * random(), random(), random(), points);
    SCOPED_TRACE(seed);
    expectBox(points);
  }
}

TEST(BlockExtent, ALineOfBlocksIsTakenOneByOne)
{
  Points points;
  for (int i = 0; i < 60; ++i) // the next one comes last
    addBlock(300 * i, 0, 0, points);
  for (int i = 0; i < 3; ++i)
    addBlock(300 * 60 + i, 0, 0, points);
  expectBox(points);
  EXPECT_EQ(blockExtent(points, 1).low.x(), -0.5);
}

TEST(BlockExtent, OfAHundredThousandLonelyBlocksTakesNoTime)
{
  Points points;
  for (int i = 0; i <= 100; ++i) // a corner of a box, and rain in it
    for (const auto& [x, y, z] : {std::tuple(i, 0, 0), {0, i, 0}, {0, 0, i}})
      addBlock(x, y, z, points);
  for (int x = 2; x <= 100; x += 2)
    for (int y = 2; y <= 100; y += 2)
      for (int z = 2; z <= 80; z += 2)
        addBlock(x, y, z, points);
  ASSERT_GT(points.size(), 100000u);
  const auto box = blockExtent(points, 1);
  EXPECT_EQ(box.low, Eigen::Vector3d(-0.5, -0.5, -0.5));
  EXPECT_EQ(box.high, Eigen::Vector3d(101.5, 101.5, 101.5));
}
