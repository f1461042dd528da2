/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/voxel_normals.h"

#include "support/bits_of.h"

#include <pcl/exceptions.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace pcl::indoor;

namespace {

using Points = std::vector<Eigen::Vector3f>;

double
drawnBetween(std::mt19937& rng, double low, double high)
{
  return low + (high - low) * static_cast<double>(rng() % 1000003) / 1000003.0;
}

/** \brief A patch around a place, with noise across it. */
void
addPatch(const Eigen::Vector3d& middle,
         const Eigen::Vector3d& normal,
         double size,
         int count,
         double noise,
         std::mt19937& rng,
         Points& points)
{
  const Eigen::Vector3d u = normal.unitOrthogonal();
  const Eigen::Vector3d v = normal.cross(u);
  for (int i = 0; i < count; ++i)
    points.push_back((middle + drawnBetween(rng, -size, size) * u +
                      drawnBetween(rng, -size, size) * v +
                      drawnBetween(rng, -noise, noise) * normal)
                         .cast<float>());
}

/** \brief The points in the voxels around one. */
std::vector<Eigen::Vector3d>
pointsAround(const Points& points, const OccupancyGrid& grid, int x, int y, int z)
{
  std::vector<Eigen::Vector3d> near;
  for (const auto& point : points) {
    const Eigen::Vector3i cell = voxelAt(grid.grid, grid.toGrid(point.cast<double>()));
    if ((cell - Eigen::Vector3i(x, y, z)).cwiseAbs().maxCoeff() <= 1)
      near.push_back(point.cast<double>());
  }
  return near;
}

/** \brief The scatter of points, computed directly. */
Eigen::Matrix3d
scatterOf(const std::vector<Eigen::Vector3d>& near)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& point : near)
    mean += point / static_cast<double>(near.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& point : near)
    scatter +=
        (point - mean) * (point - mean).transpose() / static_cast<double>(near.size());
  return scatter;
}

} // namespace

TEST(VoxelNormals, EqualTheDirectComputation)
{
  std::mt19937 rng(41);
  for (int trial = 0; trial < 10; ++trial) {
    Points points;
    const Eigen::Vector3d place(80.0, -50.0, 5.0); // far from 0: floats must hold out
    addPatch(
        place, Eigen::Vector3d(1, 2, 0.5).normalized(), 1.0, 800, 0.05, rng, points);
    addPatch(
        place, Eigen::Vector3d(0, 0.1, 1).normalized(), 1.0, 800, 0.02, rng, points);
    OccupancyGridOptions grid_options;
    grid_options.yaw = 0.2 * trial;
    const OccupancyGrid grid = occupancyGrid(points, grid_options);
    const WeightedNormals result = voxelNormals(points, grid);
    std::size_t i = 0, least = 0, most = 0; // of the normals, with those at the limit
    for (int x = 0; x < grid.grid.shape.nx; ++x)
      for (int y = 0; y < grid.grid.shape.ny; ++y)
        for (int z = 0; z < grid.grid.shape.nz; ++z) {
          if (!grid.grid.at(x, y, z))
            continue;
          const auto near = pointsAround(points, grid, x, y, z);
          if (near.size() < static_cast<std::size_t>(plane_points))
            continue;
          const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatterOf(near));
          const Eigen::Vector3d values = solver.eigenvalues();
          const double flatness = (values[1] - values[0]) / values[2];
          constexpr double tolerance = 1e-3; // of the floats that are summed up
          most += flatness >= plane_flatness - tolerance;
          if (flatness < plane_flatness + tolerance)
            continue;
          ++least;
          while (i < result.normals.size() &&
                 std::abs(result.weights[i] - flatness) > tolerance)
            ++i;
          ASSERT_LT(i, result.normals.size());
          EXPECT_GT(std::abs(result.normals[i].dot(solver.eigenvectors().col(0))),
                    0.9999);
          ++i;
        }
    EXPECT_GE(result.normals.size(), least);
    EXPECT_LE(result.normals.size(), most);
  }
}

TEST(VoxelNormals, AWallSeenFromBothSidesGivesItsDirection)
{
  std::mt19937 rng(42);
  Points points;
  const Eigen::Vector3d normal(std::cos(0.3), std::sin(0.3), 0.0);
  for (const double side : {-0.06, 0.06})
    addPatch(side * normal, normal, 2.0, 8000, 0.02, rng, points);
  const OccupancyGrid grid = occupancyGrid(points);
  const WeightedNormals result = voxelNormals(points, grid);
  ASSERT_GT(result.normals.size(), 50u);
  double good = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < result.normals.size(); ++i) {
    EXPECT_NEAR(result.normals[i].norm(), 1.0, 1e-12);
    all += result.weights[i];
    good += std::abs(result.normals[i].dot(normal)) > std::cos(0.1) ? result.weights[i]
                                                                    : 0.0;
  }
  EXPECT_GT(good / all, 0.9); // the rest is at the rim
}

TEST(VoxelNormals, SameForAnyNumberOfThreads)
{
  std::mt19937 rng(43);
  Points points;
  addPatch({0, 0, 0}, {0, 0, 1}, 2.0, 3000, 0.05, rng, points);
  const OccupancyGrid grid = occupancyGrid(points);
  const WeightedNormals one = voxelNormals(points, grid, 1);
  const WeightedNormals seven = voxelNormals(points, grid, 7);
  EXPECT_EQ(one.normals, seven.normals);
  EXPECT_EQ(one.weights, seven.weights);
}

TEST(VoxelNormals, LooksAtSomeTenThousandVoxels)
{
  std::mt19937 rng(44);
  Points points;
  addPatch({0, 0, 0}, {0, 0, 1}, 20.0, 200000, 0.05, rng, points);
  const OccupancyGrid grid = occupancyGrid(points);
  const std::size_t all = grid.grid.count();
  ASSERT_GE(all, 30000u);
  const auto kept = static_cast<double>(voxelNormals(points, grid).normals.size());
  // more than 6 sigma of a random choice; nearly all voxels have a normal
  EXPECT_NEAR(kept / static_cast<double>(all), 1.0 / (all / 10000), 0.03);
}

TEST(VoxelNormals, NoPointsAndALine)
{
  EXPECT_TRUE(voxelNormals({}, occupancyGrid({})).normals.empty());
  Points line;
  for (int i = 0; i < 100; ++i)
    line.emplace_back(0.01f * static_cast<float>(i), 0.0f, 0.0f);
  EXPECT_TRUE(voxelNormals(line, occupancyGrid(line)).normals.empty());
}

TEST(VoxelNormals, RefusesBadArguments)
{
  const Points points{{0, 0, 0}};
  const OccupancyGrid grid = occupancyGrid(points);
  EXPECT_THROW(voxelNormals({}, grid), pcl::BadArgumentException);
  EXPECT_THROW(voxelNormals(points, grid, -1), pcl::BadArgumentException);
}
