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

/** \brief The scatter of the points in the voxels around one, computed directly. */
Eigen::Matrix3d
scatterDirectly(const Points& points, const OccupancyGrid& grid, int x, int y, int z)
{
  std::vector<Eigen::Vector3d> near;
  for (const auto& point : points) {
    const Eigen::Vector3i cell = voxelAt(grid.grid, grid.toGrid(point.cast<double>()));
    if ((cell - Eigen::Vector3i(x, y, z)).cwiseAbs().maxCoeff() <= 1)
      near.push_back(point.cast<double>());
  }
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
    VoxelNormalsOptions options;
    options.keep_one_in = 1;
    options.min_flatness = 0.0;
    options.min_points = 3;
    const WeightedNormals result = voxelNormals(points, grid, options);
    std::size_t i = 0;
    for (int x = 0; x < grid.grid.shape.nx; ++x)
      for (int y = 0; y < grid.grid.shape.ny; ++y)
        for (int z = 0; z < grid.grid.shape.nz; ++z) {
          if (!grid.grid.at(x, y, z))
            continue;
          const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
              scatterDirectly(points, grid, x, y, z));
          const Eigen::Vector3d values = solver.eigenvalues();
          const double flatness = (values[1] - values[0]) / values[2];
          if (flatness < 0.01) // too round for a direction, or too few points
            continue;
          while (i < result.normals.size() && result.weights[i] < 0.01)
            ++i;
          ASSERT_LT(i, result.normals.size());
          EXPECT_NEAR(result.weights[i], flatness, 1e-3);
          EXPECT_GT(std::abs(result.normals[i].dot(solver.eigenvectors().col(0))),
                    flatness > 0.1 ? 0.9999 : 0.99);
          ++i;
        }
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
  VoxelNormalsOptions options;
  options.threads = 1;
  const WeightedNormals one = voxelNormals(points, grid, options);
  options.threads = 7;
  const WeightedNormals seven = voxelNormals(points, grid, options);
  EXPECT_EQ(one.normals, seven.normals);
  EXPECT_EQ(one.weights, seven.weights);
}

TEST(VoxelNormals, KeepsAboutOneInFour)
{
  std::mt19937 rng(44);
  Points points;
  addPatch({0, 0, 0}, {0, 0, 1}, 8.0, 60000, 0.05, rng, points);
  const OccupancyGrid grid = occupancyGrid(points);
  VoxelNormalsOptions options;
  options.keep_one_in = 1;
  const auto all =
      static_cast<double>(voxelNormals(points, grid, options).normals.size());
  options.keep_one_in = 4;
  const auto kept =
      static_cast<double>(voxelNormals(points, grid, options).normals.size());
  EXPECT_NEAR(kept / all, 0.25, 0.05); // more than 6 sigma of a random choice
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
  VoxelNormalsOptions options;
  options.keep_one_in = -1;
  EXPECT_THROW(voxelNormals(points, grid, options), pcl::BadArgumentException);
  options = {};
  options.min_points = 2;
  EXPECT_THROW(voxelNormals(points, grid, options), pcl::BadArgumentException);
  options = {};
  options.min_flatness = -0.1;
  EXPECT_THROW(voxelNormals(points, grid, options), pcl::BadArgumentException);
}
