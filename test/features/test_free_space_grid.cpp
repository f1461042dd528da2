/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "normals/free_space_grid.h" // of the library's sources

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace pcl::indoor;

namespace {

float
zeroToOne(std::mt19937& rng)
{
  return static_cast<float>(rng() % 100001) / 100000;
}

/** Points in a box of 3 x 2 x 2 m, and some at its corners. */
std::vector<Eigen::Vector3f>
pointsInBox(int count, std::mt19937& rng)
{
  std::vector<Eigen::Vector3f> points{{0, 0, 0}, {3, 2, 2}};
  for (int i = 0; i < count; ++i)
    points.emplace_back(3 * zeroToOne(rng), 2 * zeroToOne(rng), 2 * zeroToOne(rng));
  return points;
}

std::vector<Eigen::Vector3i>
cellsOf(const FreeSpaceGrid& grid, const std::vector<Eigen::Vector3f>& points)
{
  std::vector<Eigen::Vector3i> cells;
  for (const auto& point : points) {
    const auto cell = grid.cellOf(point.cast<double>());
    if (grid.contains(cell))
      cells.push_back(cell);
  }
  return cells;
}

/** How much of the line lies in a cell, in cells; the line is given in cells, too. */
double
lengthInCell(const Eigen::Vector3d& start,
             const Eigen::Vector3d& way,
             double length,
             const Eigen::Vector3i& cell)
{
  double enter = 0, leave = length;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(way[axis]) < 1e-12) {
      if (start[axis] < cell[axis] || start[axis] >= cell[axis] + 1)
        return 0;
      continue;
    }
    const double a = (cell[axis] - start[axis]) / way[axis];
    const double b = (cell[axis] + 1 - start[axis]) / way[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return std::max(0.0, leave - enter);
}

} // namespace

TEST(FreeSpaceGrid, ClearanceIsTheCityBlockDistance)
{
  std::mt19937 rng(1);
  const auto points = pointsInBox(6, rng);
  const FreeSpaceGrid grid(points, 0.2);
  const auto occupied = cellsOf(grid, points);
  Eigen::Vector3i cell;
  for (cell.x() = 0; cell.x() < grid.shape().x(); ++cell.x())
    for (cell.y() = 0; cell.y() < grid.shape().y(); ++cell.y())
      for (cell.z() = 0; cell.z() < grid.shape().z(); ++cell.z()) {
        int nearest = 255;
        for (const auto& other : occupied)
          nearest = std::min(nearest, (cell - other).lpNorm<1>());
        EXPECT_EQ(grid.clearance(grid.index(cell)), nearest) << cell.transpose();
      }
}

TEST(FreeSpaceGrid, SightIsThatOfBruteForce)
{
  std::mt19937 rng(2);
  std::size_t seen = 0, judged = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const auto points = pointsInBox(40 * trial, rng);
    const FreeSpaceGrid grid(points, 0.05);
    const auto occupied = cellsOf(grid, points);
    const Eigen::Vector3d origin =
        grid.center({0, 0, 0}).cast<double>().array() - grid.cellSize() / 2;
    for (int line = 0; line < 200; ++line) {
      const Eigen::Vector3f from(
          3 * zeroToOne(rng), 2 * zeroToOne(rng), 2 * zeroToOne(rng));
      // A point, or a place that may lie outside of the box.
      const Eigen::Vector3f to = line % 2 ? points[rng() % points.size()]
                                          : Eigen::Vector3f(5 * zeroToOne(rng) - 1,
                                                            2 * zeroToOne(rng),
                                                            3 * zeroToOne(rng));
      const Eigen::Vector3d start = (from.cast<double>() - origin) / grid.cellSize();
      const Eigen::Vector3d end = (to.cast<double>() - origin) / grid.cellSize();
      const double length = (end - start).norm();
      const Eigen::Vector3d way = (end - start) / length;
      const Eigen::Vector3i first = start.array().floor().cast<int>();
      double most = 0;
      bool doubtful = false;
      for (const auto& cell : occupied) {
        if (cell == first)
          continue;
        const double inside = lengthInCell(start, way, length - 1.8, cell);
        doubtful = doubtful || (inside > 0 && inside < 1e-3);
        most = std::max(most, inside);
      }
      if (doubtful)
        continue;
      ++judged;
      seen += most == 0;
      EXPECT_EQ(grid.sees(from, to), most == 0)
          << trial << ": " << from.transpose() << " to " << to.transpose();
    }
  }
  EXPECT_GT(judged, 3800u);
  EXPECT_GT(seen, judged / 5);
  EXPECT_LT(seen, 19 * judged / 20);
}

TEST(FreeSpaceGrid, PlacesFarOutsideAreInNoCell)
{
  const FreeSpaceGrid grid({{0, 0, 0}, {1, 1, 1}}, 0.1);
  for (const double far : {1e3, 1e10, 1e38, 1e300})
    for (const double sign : {-1.0, 1.0})
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_FALSE(
            grid.contains(grid.cellOf(sign * far * Eigen::Vector3d::Unit(axis))))
            << sign * far;
  EXPECT_TRUE(grid.sees({1e30f, 0.5f, 0.5f}, {2e30f, 0.5f, 0.5f}));
}
