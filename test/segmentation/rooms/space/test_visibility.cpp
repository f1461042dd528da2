/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/visibility.h"
#include "thesis/rooms/visibility_vectors.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <random>

using Eigen::Vector3i;
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

Vector3i
randomVoxel(const VoxelMap<std::uint8_t>& grid, std::mt19937& rng)
{
  return {static_cast<int>(rng() % grid.shape.nx),
          static_cast<int>(rng() % grid.shape.ny),
          static_cast<int>(rng() % grid.shape.nz)};
}

/** Whether the segment between the centres of a and b crosses the inside of a voxel:
 * clips it against the voxel, all times as fractions of the same denominator.
 */
bool
crossesInside(const Vector3i& a, const Vector3i& b, const Vector3i& voxel)
{
  std::int64_t product = 1; // a common denominator, times 2
  for (int axis = 0; axis < 3; ++axis)
    product *= std::max(std::abs(b[axis] - a[axis]), 1);
  std::int64_t enters = 0, leaves = 2 * product;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t extent = b[axis] - a[axis];
    const std::int64_t low = 2 * (voxel[axis] - a[axis]) - 1, high = low + 2;
    if (extent == 0) {
      if (voxel[axis] != a[axis])
        return false;
      continue;
    }
    const std::int64_t t0 = low * product / extent, t1 = high * product / extent;
    enters = std::max(enters, std::min(t0, t1));
    leaves = std::min(leaves, std::max(t0, t1));
  }
  return enters < leaves;
}

bool
seesBruteForce(const VoxelMap<std::uint8_t>& grid, const Vector3i& a, const Vector3i& b)
{
  for (int x = 0; x < grid.shape.nx; ++x)
    for (int y = 0; y < grid.shape.ny; ++y)
      for (int z = 0; z < grid.shape.nz; ++z) {
        const Vector3i voxel(x, y, z);
        if (grid.at(x, y, z) && voxel != a && voxel != b && crossesInside(a, b, voxel))
          return false;
      }
  return true;
}

/** s_l(i) of Eq. (3.5). */
bool
seesLandmark(const pcl::indoor::VisibilityVectors& vectors,
             std::size_t i,
             std::size_t landmark)
{
  return (vectors.bits[i * vectors.words + landmark / 64] >> (landmark % 64)) & 1u;
}

} // namespace

TEST(LineOfSight, EqualsBruteForceAndIsSymmetric)
{
  std::mt19937 rng(1);
  int visible = 0, pairs = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const auto grid =
        randomGrid(1 + rng() % 12, 1 + rng() % 12, 1 + rng() % 6, 5 + rng() % 40, rng);
    for (int pair = 0; pair < 60; ++pair) {
      const auto a = randomVoxel(grid, rng), b = randomVoxel(grid, rng);
      const bool expected = seesBruteForce(grid, a, b);
      ASSERT_EQ(pcl::indoor::lineOfSight(grid, a, b), expected)
          << a.transpose() << " to " << b.transpose();
      ASSERT_EQ(pcl::indoor::lineOfSight(grid, b, a), expected);
      visible += expected;
      ++pairs;
    }
  }
  EXPECT_GT(visible, pairs / 10); // both answers occur
  EXPECT_LT(visible, pairs * 9 / 10);
}

TEST(VisibilityVectors, HoldTheLinesOfSight)
{
  std::mt19937 rng(2);
  const auto grid = randomGrid(20, 20, 4, 12, rng);
  std::vector<Vector3i> voxels, landmarks;
  for (int i = 0; i < 150; ++i)
    voxels.push_back(randomVoxel(grid, rng));
  for (int i = 0; i < 131; ++i)
    landmarks.push_back(randomVoxel(grid, rng));
  const auto vectors = pcl::indoor::visibilityVectors(grid, voxels, landmarks, 3);
  EXPECT_EQ(vectors.words, 3u);
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    std::uint32_t visible = 0;
    for (std::size_t l = 0; l < landmarks.size(); ++l) {
      const bool sees = pcl::indoor::lineOfSight(grid, voxels[i], landmarks[l]);
      ASSERT_EQ(seesLandmark(vectors, i, l), sees);
      visible += sees;
    }
    EXPECT_EQ(vectors.visible[i], visible);
  }
  EXPECT_EQ(pcl::indoor::visibilityVectors(grid, voxels, landmarks, 1).bits,
            vectors.bits);
  EXPECT_THROW(pcl::indoor::visibilityVectors(grid, {{20, 0, 0}}, {}),
               pcl::BadArgumentException);
}

TEST(VisibilityDistance, CountsPositionsThatDiffer)
{
  std::mt19937 rng(3);
  const auto grid = randomGrid(20, 20, 3, 12, rng);
  std::vector<Vector3i> voxels;
  for (int i = 0; i < 70; ++i)
    voxels.push_back(randomVoxel(grid, rng));
  const auto vectors = pcl::indoor::visibilityVectors(grid, voxels, voxels);
  for (std::size_t i = 0; i < voxels.size(); ++i)
    for (std::size_t j = 0; j < voxels.size(); ++j) {
      double differing = 0.0, sum = 0.0;
      for (std::size_t l = 0; l < voxels.size(); ++l) {
        differing += seesLandmark(vectors, i, l) != seesLandmark(vectors, j, l);
        sum += seesLandmark(vectors, i, l) + seesLandmark(vectors, j, l);
      }
      ASSERT_EQ(pcl::indoor::visibilityDistance(vectors, i, j), differing / sum);
    }
  const auto blind = pcl::indoor::visibilityVectors(grid, voxels, {});
  EXPECT_EQ(pcl::indoor::visibilityDistance(blind, 0, 1), 0.0);
}

TEST(VisibilityDistance, IsBoundedByTheGroup)
{
  std::mt19937 rng(5);
  for (int trial = 0; trial < 20; ++trial) {
    const auto grid = randomGrid(20, 20, 3, 5 + rng() % 40, rng);
    std::vector<Vector3i> voxels;
    for (int i = 0; i < 70; ++i)
      voxels.push_back(randomVoxel(grid, rng));
    const auto vectors = pcl::indoor::visibilityVectors(grid, voxels, voxels);
    pcl::indoor::VisibilityGroup group, single;
    for (std::size_t j = 0; j < 5; ++j)
      group.add(vectors, j);
    single.add(vectors, 0);
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      for (std::size_t j = 0; j < 5; ++j)
        EXPECT_LE(pcl::indoor::leastVisibilityDistance(vectors, i, group),
                  pcl::indoor::visibilityDistance(vectors, i, j));
      EXPECT_EQ(pcl::indoor::leastVisibilityDistance(vectors, i, single),
                pcl::indoor::visibilityDistance(vectors, i, 0));
    }
  }
}

TEST(VisibilityDistance, SeparatesRooms)
{
  // two rooms with a wall between them and a door at y = 4
  std::mt19937 rng(4);
  auto grid = randomGrid(21, 9, 3, 1, rng);
  for (auto& value : grid.values)
    value = 0;
  for (int y = 0; y < 9; ++y)
    for (int z = 0; z < 3; ++z)
      grid.at(10, y, z) = y != 4;
  std::vector<Vector3i> all;
  for (int x = 0; x < 21; ++x)
    for (int y = 0; y < 9; ++y)
      if (!grid.at(x, y, 1))
        all.emplace_back(x, y, 1);
  const auto vectors = pcl::indoor::visibilityVectors(
      grid, {{2, 1, 1}, {8, 7, 1}, {12, 7, 1}, {18, 1, 1}}, all);
  const auto distance = [&](std::size_t i, std::size_t j) {
    return pcl::indoor::visibilityDistance(vectors, i, j);
  };
  EXPECT_LT(distance(0, 1), 0.2);
  EXPECT_LT(distance(2, 3), 0.2);
  EXPECT_GT(distance(1, 2), 0.6);
  EXPECT_EQ(distance(1, 2), distance(2, 1));
}

TEST(SpreadLandmarks, TakesOnePerSquare)
{
  pcl::indoor::PixelMap<int> heights{7, 5, std::vector<int>(35, -1)};
  heights.at(1, 1) = 3;
  heights.at(0, 0) = 2;
  heights.at(6, 4) = 1;
  const auto landmarks = pcl::indoor::spreadLandmarks(heights, 3);
  ASSERT_EQ(landmarks.size(), 2u);
  EXPECT_EQ(landmarks[0], Vector3i(1, 1, 3));
  EXPECT_EQ(landmarks[1], Vector3i(6, 4, 1));
  EXPECT_EQ(pcl::indoor::spreadLandmarks(heights, 1).size(), 3u);
  EXPECT_THROW(pcl::indoor::spreadLandmarks(heights, 0), pcl::BadArgumentException);
}
