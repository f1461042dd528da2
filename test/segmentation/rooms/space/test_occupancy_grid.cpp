/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/occupancy_grid.h"
#include "support/bits_of.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <vector>

using namespace pcl::indoor;

namespace {

using Points = std::vector<Eigen::Vector3f>;

float
uniform(std::mt19937& rng, float low, float high)
{
  return low + (high - low) * static_cast<float>(rng() % 1000003) / 1000002.0f;
}

/** \brief A box of densely filled space. */
void
addCloud(const Eigen::Vector3f& low,
         const Eigen::Vector3f& high,
         int count,
         std::mt19937& rng,
         Points& points)
{
  for (int i = 0; i < count; ++i)
    points.emplace_back(uniform(rng, low.x(), high.x()),
                        uniform(rng, low.y(), high.y()),
                        uniform(rng, low.z(), high.z()));
}

/** The number of points outside the grid. */
std::ptrdiff_t
outsideOf(const OccupancyGrid& grid)
{
  return std::count(grid.cells.begin(), grid.cells.end(), -1);
}

} // namespace

TEST(OccupancyGrid, MarksExactlyTheVoxelsWithPoints)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 20; ++trial) {
    Points points;
    addCloud({-3, -2, -1}, {4, 5, 2}, 300, rng, points);
    OccupancyGridOptions options;
    options.voxel_size = 0.15 + 0.05 * (trial % 5);
    options.yaw = 0.3 * trial;
    const OccupancyGrid result = occupancyGrid(points, options);
    std::set<std::size_t> expected;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d local = result.toGrid(points[i].cast<double>());
      EXPECT_LT((result.toBuilding(local) - points[i].cast<double>()).norm(), 1e-12);
      const Eigen::Vector3i cell = voxelAt(result.grid, local);
      ASSERT_TRUE(result.grid.shape.contains(cell.x(), cell.y(), cell.z()));
      const std::size_t index = result.grid.shape.index(cell.x(), cell.y(), cell.z());
      EXPECT_EQ(result.cells[i], static_cast<std::int32_t>(index)) << "trial " << trial;
      expected.insert(index);
    }
    EXPECT_EQ(outsideOf(result), 0);
    const GridShape& shape = result.grid.shape;
    for (int x = 0; x < shape.nx; ++x)
      for (int y = 0; y < shape.ny; ++y)
        for (int z = 0; z < shape.nz; ++z)
          EXPECT_EQ(result.grid.at(x, y, z), expected.count(shape.index(x, y, z)) > 0)
              << "voxel " << x << ", " << y << ", " << z;
  }
}

TEST(OccupancyGrid, LeavesAFreeMarginAndNoMore)
{
  std::mt19937 rng(2);
  Points points;
  addCloud({0, 0, 0}, {3, 4, 2}, 20000, rng, points);
  const OccupancyGrid result = occupancyGrid(points);
  const GridShape shape = result.grid.shape;
  Eigen::Vector3i low(shape.nx, shape.ny, shape.nz);
  Eigen::Vector3i high(0, 0, 0);
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y)
      for (int z = 0; z < shape.nz; ++z)
        if (result.grid.at(x, y, z)) {
          low = low.cwiseMin(Eigen::Vector3i(x, y, z));
          high = high.cwiseMax(Eigen::Vector3i(x, y, z));
        }
  EXPECT_EQ(low, Eigen::Vector3i::Constant(1));
  EXPECT_EQ(high,
            Eigen::Vector3i(shape.nx, shape.ny, shape.nz) -
                Eigen::Vector3i::Constant(2));
}

TEST(OccupancyGrid, OutliersFarAwayDoNotEnlargeTheGrid)
{
  std::mt19937 rng(3);
  Points points;
  addCloud({0, 0, 0}, {20, 10, 3}, 100000, rng, points);
  const OccupancyGrid clean = occupancyGrid(points);
  const std::size_t inliers = points.size();
  addCloud({-900, -900, -500}, {900, 900, 500}, 300, rng, points); // scattered
  addCloud({700, 0, 0}, {701, 1, 1}, 500, rng, points);            // in a heap
  points.emplace_back(3e8f, -3e8f, 1e30f);
  const OccupancyGrid result = occupancyGrid(points);
  EXPECT_LT(result.grid.shape.size(), 2 * clean.grid.shape.size());
  for (std::size_t i = 0; i < inliers; ++i)
    ASSERT_GE(result.cells[i], 0);
  EXPECT_GT(outsideOf(result), 790);
}

TEST(OccupancyGrid, KeepsSeparateRoomsAndASecondBuilding)
{
  std::mt19937 rng(4);
  Points points;
  addCloud({0, 0, 0}, {20, 10, 3}, 100000, rng, points);
  addCloud({25, 0, 0}, {29, 4, 3}, 2000, rng, points);      // 2 % of the points
  addCloud({0, 60, 0}, {30, 80, 9}, 100000, rng, points);   // 50 m away
  addCloud({100, 10, -1}, {110, 20, 2}, 5000, rng, points); // joined by no block
  EXPECT_EQ(outsideOf(occupancyGrid(points)), 0);
}

TEST(OccupancyGrid, SparseScansKeepTheirPoints)
{
  std::mt19937 rng(5);
  Points points;
  addCloud({0, 0, 0}, {30, 20, 0.01f}, 2000, rng, points); // some 3 points per m^2
  EXPECT_EQ(outsideOf(occupancyGrid(points)), 0);
}

TEST(OccupancyGrid, SameForAnyOrderAndAnyNumberOfThreads)
{
  std::mt19937 rng(6);
  Points points;
  addCloud({0, 0, 0}, {20, 10, 3}, 30000, rng, points);
  addCloud({-400, -400, -100}, {400, 400, 100}, 100, rng, points);
  OccupancyGridOptions options;
  options.yaw = 0.5;
  options.threads = 1;
  const OccupancyGrid one = occupancyGrid(points, options);
  options.threads = std::numeric_limits<int>::max(); // far more than there can be
  EXPECT_EQ(occupancyGrid(points, options).cells, one.cells);
  options.threads = 8;
  const OccupancyGrid eight = occupancyGrid(points, options);
  EXPECT_EQ(bitsOf(one.grid), bitsOf(eight.grid));
  EXPECT_EQ(one.cells, eight.cells);
  EXPECT_EQ(one.grid.origin, eight.grid.origin);
  Points reversed(points.rbegin(), points.rend());
  const OccupancyGrid other = occupancyGrid(reversed, options);
  EXPECT_EQ(bitsOf(one.grid), bitsOf(other.grid));
  EXPECT_EQ(one.grid.origin, other.grid.origin);
  EXPECT_TRUE(std::equal(one.cells.begin(), one.cells.end(), other.cells.rbegin()));
}

TEST(OccupancyGrid, NoPointsAndOnePoint)
{
  const OccupancyGrid none = occupancyGrid({});
  EXPECT_EQ(none.grid.shape.size(), 0u);
  EXPECT_TRUE(none.cells.empty());
  const OccupancyGrid one = occupancyGrid({{5.0f, -7.0f, 1.0f}});
  EXPECT_EQ(one.grid.shape.size(), 27u);
  EXPECT_EQ(one.cells, std::vector<std::int32_t>{13});
}

TEST(OccupancyGrid, RefusesOptionsOutOfRange)
{
  const Points points{{0, 0, 0}, {2, 2, 2}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](auto member, auto value) {
    OccupancyGridOptions options;
    options.*member = value;
    EXPECT_THROW(occupancyGrid(points, options), pcl::BadArgumentException);
  };
  refused(&OccupancyGridOptions::voxel_size, 0.0);
  refused(&OccupancyGridOptions::voxel_size, nan);
  refused(&OccupancyGridOptions::voxel_size, 1e-4); // 8e12 voxels
  refused(&OccupancyGridOptions::yaw, nan);
  refused(&OccupancyGridOptions::threads, -1);
}
