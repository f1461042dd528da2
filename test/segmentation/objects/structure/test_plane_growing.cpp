/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "objects/structure/plane_growing.h"
#include "support/labelled_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

constexpr double growing_voxel_size = 0.04;

std::vector<StructurePlane>
planesOf(const LabelledPoints& scene, SurfaceVoxels& voxels)
{
  voxels = surfaceVoxels(scene.points, {}, growing_voxel_size);
  estimateNormals(scene.points, voxels, 1);
  for (auto& normal : voxels.normals) // all are seen from above and before
    if (normal.dot(Eigen::Vector3f(0.1f, -1, 1)) < 0)
      normal *= -1;
  return growPlanes(voxels, growing_voxel_size, 0.03f);
}

void
addLevel(const Eigen::Vector3f& corner,
         float length,
         LabelledPoints& scene,
         std::mt19937& rng)
{
  scene.addRectangle(
      corner, {length, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, 0.02f, 0.002f, rng);
}

} // namespace

TEST(PlaneGrowing, RegionsOfOnePlaneAreOneHoweverFarApart)
{
  std::mt19937 rng(1);
  LabelledPoints scene;
  addLevel({0, 0, 0}, 2, scene, rng);
  addLevel({4, 0, 0}, 1.5f, scene, rng);
  addLevel({2.5f, 0, 0.4f}, 1, scene, rng); // another, parallel to it
  scene.addRectangle(
      {0, 2.02f, 0.2f}, {1.8f, 0, 0}, {0, 0, 1}, {0, -1, 0}, 1, 0.02f, 0.002f, rng);
  SurfaceVoxels voxels;
  const auto planes = planesOf(scene, voxels);
  ASSERT_EQ(planes.size(), 3u) << "by their largest regions";
  EXPECT_NEAR(planes[0].offset, 0, 0.005);
  EXPECT_GT(planes[0].normal.z(), 0.999);
  EXPECT_LT(planes[1].normal.y(), -0.999);
  EXPECT_NEAR(planes[2].offset, 0.4, 0.005);
  std::vector<int> times(voxels.size(), 0);
  double lowest = 9, highest = 0;
  for (const auto& plane : planes)
    for (const auto v : plane.voxels) {
      ++times[v];
      EXPECT_LE(std::abs(plane.heightOf(voxels.centroids[v].cast<double>())),
                1.5 * growing_voxel_size);
      if (&plane == &planes[0]) {
        lowest = std::min<double>(lowest, voxels.centroids[v].x());
        highest = std::max<double>(highest, voxels.centroids[v].x());
      }
    }
  EXPECT_EQ(*std::max_element(times.begin(), times.end()), 1);
  EXPECT_LT(lowest, 0.1);
  EXPECT_GT(highest, 5.4);
}

TEST(PlaneGrowing, WhatIsSmallOrRoughIsNone)
{
  std::mt19937 rng(2);
  LabelledPoints scene;
  scene.addRectangle({0, 0, 0}, // 7 x 7 voxels
                     {0.27f, 0, 0},
                     {0, 0.27f, 0},
                     {0, 0, 1},
                     1,
                     0.02f,
                     0.002f,
                     rng);
  scene.addRectangle({1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, 0.02f, 0.15f, rng);
  SurfaceVoxels voxels;
  EXPECT_TRUE(planesOf(scene, voxels).empty());
  EXPECT_TRUE(growPlanes(surfaceVoxels({}, {}, 1), growing_voxel_size, 0.03f).empty());
}
