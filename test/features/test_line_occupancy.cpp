/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/line_occupancy.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pcl::indoor {
namespace {

std::vector<OrientedPoint>
pointsInCube(std::size_t count, std::mt19937& rng)
{
  std::vector<OrientedPoint> points(count);
  const auto draw = [&] { return static_cast<float>(rng() % 100001) / 100000.0f; };
  for (auto& point : points)
    point.position = {draw(), draw(), draw()};
  // Opposite corners fix the cube: voxel k covers k / n to (k + 1) / n on each axis.
  points[0].position = {0.0f, 0.0f, 0.0f};
  points[1].position = {1.0f, 1.0f, 1.0f};
  return points;
}

Eigen::Vector3i
voxelOf(const Eigen::Vector3f& position, int grid_size)
{
  Eigen::Vector3i voxel;
  for (int axis = 0; axis < 3; ++axis)
    voxel[axis] = std::min(
        static_cast<int>(std::floor(position[axis] * static_cast<float>(grid_size))),
        grid_size - 1);
  return voxel;
}

/** \brief What a line met. */
struct Count {
  int occupied = 0; ///< N_occ of Eq. (5.8)
  int total = 0;    ///< N_total of Eq. (5.8)
};

Count
countBetween(const LineOccupancy& grid,
             const Eigen::Vector3f& from,
             const Eigen::Vector3f& to)
{
  const auto line = grid.lineBetween(grid.cell(from), grid.cell(to));
  return {static_cast<int>(grid.countOccupied(line)), line.steps + 1};
}

/** \brief Counts with real numbers, one slice of the longest axis after the other. */
Count
countSlowly(const std::vector<OrientedPoint>& points,
            const Eigen::Vector3i& from,
            const Eigen::Vector3i& to,
            int grid_size)
{
  const int steps = (to - from).cwiseAbs().maxCoeff();
  Count count;
  for (int k = 0; k <= steps; ++k) {
    // Exactly between two voxels the lower one counts.
    const double part = steps == 0 ? 0.0 : static_cast<double>(k) / steps;
    const Eigen::Array3d middle = from.cast<double>().array() + 0.5 - 1e-9;
    const Eigen::Array3d place = middle + part * (to - from).cast<double>().array();
    const Eigen::Vector3i voxel = place.floor().cast<int>().matrix();
    ++count.total;
    for (const auto& point : points)
      if (voxelOf(point.position, grid_size) == voxel) {
        ++count.occupied;
        break;
      }
  }
  return count;
}

TEST(LineOccupancy, CountsWhatASlowWalkCounts)
{
  std::mt19937 rng(7);
  for (const int grid_size : {2, 5, 16, 64}) {
    const auto points = pointsInCube(300, rng);
    const LineOccupancy grid(points, grid_size);
    for (int trial = 0; trial < 200; ++trial) {
      const auto& from = points[rng() % points.size()].position;
      const auto& to = points[rng() % points.size()].position;
      const auto expected = countSlowly(
          points, voxelOf(from, grid_size), voxelOf(to, grid_size), grid_size);
      const auto count = countBetween(grid, from, to);
      EXPECT_EQ(count.total, expected.total);
      EXPECT_EQ(count.occupied, expected.occupied)
          << "grid " << grid_size << ", trial " << trial;
    }
  }
}

TEST(LineOccupancy, FullGridIsFullAlongEveryLine)
{
  std::vector<OrientedPoint> points;
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y)
      for (int z = 0; z < 8; ++z) {
        points.emplace_back();
        points.back().position = Eigen::Vector3i(x, y, z).cast<float>();
      }
  const LineOccupancy grid(points, 8);
  for (const auto& from : points)
    for (const auto& to : points) {
      const auto count = countBetween(grid, from.position, to.position);
      EXPECT_EQ(count.occupied, count.total);
      EXPECT_EQ(
          count.total,
          1 + static_cast<int>((to.position - from.position).cwiseAbs().maxCoeff()));
    }
}

TEST(LineOccupancy, EndsAreCountedAndOccupied)
{
  std::vector<OrientedPoint> points(2);
  points[1].position = {1.0f, 0.5f, 0.25f};
  const LineOccupancy grid(points, 64);
  const auto count = countBetween(grid, points[0].position, points[1].position);
  EXPECT_EQ(count.total, 64);
  EXPECT_EQ(count.occupied, 2);
}

TEST(LineOccupancy, PointsInOnePlaceShareAVoxel)
{
  const std::vector<OrientedPoint> points(3);
  const LineOccupancy grid(points, 64);
  const auto count = countBetween(grid, points[0].position, points[1].position);
  EXPECT_EQ(count.total, 1);
  EXPECT_EQ(count.occupied, 1);
}

} // namespace
} // namespace pcl::indoor
