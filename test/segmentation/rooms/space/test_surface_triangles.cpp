/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/surface_triangles.h"

#include "support/bits_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace pcl::indoor;
using Points = std::vector<Eigen::Vector3f>;

namespace {

constexpr float noise = 0.01f; // metres

/** A level patch of 4 x 3 m whose points have this mean spacing, or the wall that
 * stands on its edge along x. */
void
addPatch(bool is_wall, float spacing, std::mt19937& rng, Points& points)
{
  std::uniform_real_distribution<float> along(0.0f, 4.0f), across(0.0f, 3.0f);
  std::normal_distribution<float> off(0.0f, noise);
  const auto count = static_cast<int>(12.0f / (spacing * spacing));
  for (int i = 0; i < count; ++i) {
    const float x = along(rng), y = across(rng), z = off(rng);
    points.push_back(is_wall ? Eigen::Vector3f(x, z, y) : Eigen::Vector3f(x, y, z));
  }
}

/** The grid of some points with the triangles between them. */
OccupancyGrid
closedGrid(const Points& points, int threads = 1)
{
  OccupancyGridOptions options;
  options.voxel_size = 0.1;
  OccupancyGrid grid = occupancyGrid(points, options);
  addTriangles(surfaceTriangles(points, options.voxel_size, threads), threads, grid);
  return grid;
}

/** Whether something is within a voxel of a place. */
bool
isOccupiedAt(const OccupancyGrid& occupancy, const Eigen::Vector3d& place)
{
  const auto& grid = occupancy.grid;
  const Eigen::Vector3i at =
      ((place - grid.origin) / grid.voxel_size).array().floor().cast<int>();
  for (int x = at.x() - 1; x <= at.x() + 1; ++x)
    for (int y = at.y() - 1; y <= at.y() + 1; ++y)
      for (int z = at.z() - 1; z <= at.z() + 1; ++z)
        if (grid.shape.contains(x, y, z) && grid.at(x, y, z))
          return true;
  return false;
}

/** The share of the places 5 cm apart of a patch at which something is. */
double
closedShare(bool is_wall, const OccupancyGrid& grid, double margin)
{
  int closed = 0, all = 0;
  for (double x = margin; x <= 4.0 - margin; x += 0.05)
    for (double y = margin; y <= 3.0 - margin; y += 0.05) {
      ++all;
      closed += isOccupiedAt(
          grid, is_wall ? Eigen::Vector3d(x, 0.0, y) : Eigen::Vector3d(x, y, 0.0));
    }
  return static_cast<double>(closed) / all;
}

} // namespace

TEST(SurfaceTriangles, CloseASurfaceOfSparsePoints)
{
  for (const float spacing : {0.15f, 0.2f, 0.3f}) {
    std::mt19937 rng(1);
    Points points;
    addPatch(false, spacing, rng, points);
    OccupancyGridOptions options;
    options.voxel_size = 0.1;
    const auto open = occupancyGrid(points, options);
    EXPECT_LT(closedShare(false, open, 0.4), 0.999) << spacing;
    const auto closed = closedGrid(points);
    EXPECT_GT(closedShare(false, closed, 0.4), spacing < 0.25f ? 0.999 : 0.95)
        << spacing;
    for (int z = 0; z < closed.grid.shape.nz; ++z) { // it stays as thin as its points
      const double height = closed.grid.origin.z() + (z + 0.5) * 0.1;
      if (std::abs(height) < 0.05 + 5.0 * noise)
        continue;
      for (int x = 0; x < closed.grid.shape.nx; ++x)
        for (int y = 0; y < closed.grid.shape.ny; ++y)
          EXPECT_FALSE(closed.grid.at(x, y, z)) << spacing << " at " << height;
    }
  }
}

TEST(SurfaceTriangles, CloseBothSurfacesUpToTheirEdge)
{
  std::mt19937 rng(2);
  Points points;
  addPatch(false, 0.2f, rng, points);
  addPatch(true, 0.2f, rng, points);
  const auto grid = closedGrid(points);
  for (double x = 0.4; x <= 3.6; x += 0.05)
    for (const double away : {0.05, 0.1, 0.15, 0.2, 0.3}) {
      EXPECT_TRUE(isOccupiedAt(grid, {x, away, 0.0})) << x << " " << away;
      EXPECT_TRUE(isOccupiedAt(grid, {x, 0.0, away})) << x << " " << away;
    }
}

TEST(SurfaceTriangles, LeaveADoorwayOpen)
{
  std::mt19937 rng(3);
  Points points;
  addPatch(true, 0.2f, rng, points);
  points.erase(std::remove_if(points.begin(),
                              points.end(),
                              [](const auto& p) {
                                return p.x() > 1.5f && p.x() < 2.4f && p.z() < 2.0f;
                              }),
               points.end());
  const auto grid = closedGrid(points);
  for (double z = 0.3; z <= 1.4; z += 0.05)
    EXPECT_FALSE(isOccupiedAt(grid, {1.95, 0.0, z})) << z;
  EXPECT_TRUE(isOccupiedAt(grid, {1.95, 0.0, 2.4}));
}

TEST(SurfaceTriangles, HardlyJoinNoise)
{
  std::mt19937 rng(4);
  std::uniform_real_distribution<float> side(0.0f, 3.0f);
  Points points;
  for (int i = 0; i < 1000; ++i) // 30 cm apart
    points.emplace_back(side(rng), side(rng), side(rng));
  const auto perPlace = [](const SurfaceTriangles& triangles) {
    return static_cast<double>(triangles.corners.size()) /
           static_cast<double>(triangles.places.size());
  };
  EXPECT_LT(perPlace(surfaceTriangles(points, 0.1, 1)), 1.0);
  Points surface;
  addPatch(false, 0.2f, rng, surface);
  EXPECT_GT(perPlace(surfaceTriangles(surface, 0.1, 1)), 4.0);
}

TEST(SurfaceTriangles, AreTheSameForAnyNumberOfThreadsAndOrder)
{
  std::mt19937 rng(5);
  Points points;
  addPatch(false, 0.15f, rng, points);
  addPatch(true, 0.25f, rng, points);
  const auto one = surfaceTriangles(points, 0.1, 1);
  const auto four = surfaceTriangles(points, 0.1, 4);
  EXPECT_EQ(one.places, four.places);
  EXPECT_EQ(one.corners, four.corners);
  EXPECT_EQ(bitsOf(closedGrid(points, 1).grid), bitsOf(closedGrid(points, 4).grid));
  std::shuffle(points.begin(), points.end(), rng);
  const auto shuffled = surfaceTriangles(points, 0.1, 1);
  ASSERT_EQ(one.places.size(), shuffled.places.size());
  for (std::size_t i = 0; i < one.places.size(); ++i)
    EXPECT_LT((one.places[i] - shuffled.places[i]).norm(), 1e-5f);
  EXPECT_EQ(one.corners, shuffled.corners);
}

TEST(SurfaceTriangles, AreNoneOfFewPoints)
{
  EXPECT_TRUE(surfaceTriangles({}, 0.1, 1).corners.empty());
  EXPECT_TRUE(surfaceTriangles({{0, 0, 0}, {0.2f, 0, 0}}, 0.1, 1).corners.empty());
}
