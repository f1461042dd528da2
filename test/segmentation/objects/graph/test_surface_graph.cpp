/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "objects/graph/surface_graph.h"
#include "support/labelled_points.h"

#include <pcl/exceptions.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/lccp_segmentation.h>
#include <pcl/segmentation/supervoxel_clustering.h>

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace pcl::indoor;
using pcl::indoor::test::floorWithTwoBoxes;
using Labels = std::vector<std::uint32_t>;

namespace {

SurfaceVoxels
voxelsOf(const test::LabelledPoints& scene, double size = 0.03)
{
  auto voxels = surfaceVoxels(scene.points, {}, size);
  estimateNormals(scene.points, voxels, 1);
  averageNormals(scene.normals, voxels);
  return voxels;
}

/** Flags that leave no voxel out. */
std::vector<std::uint8_t>
allOf(const SurfaceVoxels& voxels)
{
  return std::vector<std::uint8_t>(voxels.size(), 0);
}

bool
isConnected(const SurfaceVoxels& voxels, const Labels& labels, std::uint32_t label)
{
  std::vector<std::uint32_t> stack;
  std::vector<std::uint8_t> seen(labels.size(), 0);
  const auto first = std::find(labels.begin(), labels.end(), label) - labels.begin();
  stack.push_back(static_cast<std::uint32_t>(first));
  seen[first] = 1;
  std::ptrdiff_t reached = 0;
  while (!stack.empty()) {
    const auto v = stack.back();
    stack.pop_back();
    ++reached;
    for (const auto other : voxels.neighbors.of(v)) {
      if (!seen[other] && labels[other] == label) {
        seen[other] = 1;
        stack.push_back(other);
      }
    }
  }
  return reached == std::count(labels.begin(), labels.end(), label);
}

} // namespace

TEST(SurfaceVoxels, NormalsOfPlanesAreExactAndTheirCurvatureIsNoise)
{
  std::mt19937 rng(1);
  test::LabelledPoints plane;
  plane.addRectangle({10, 5, 1}, {1, 0, 1}, {0, 1, 0}, {0, 0, 1}, 1, 0.01f, 0, rng);
  auto voxels = surfaceVoxels(plane.points, {}, 0.05);
  estimateNormals(plane.points, voxels, 1);
  const Eigen::Vector3f expected = Eigen::Vector3f(1, 0, -1).normalized();
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    EXPECT_NEAR(std::abs(voxels.normals[v].dot(expected)), 1, 1e-4); // float points
    EXPECT_LT(voxels.curvatures[v], 1e-4f);
  }
}

TEST(SurfaceVoxels, NormalsAreThoseOfTheFullCovariance)
{
  const auto scene = floorWithTwoBoxes(0.01f, 0.02f);
  auto voxels = surfaceVoxels(scene.points, {}, 0.04);
  estimateNormals(scene.points, voxels, 1);
  for (std::size_t v = 0; v < voxels.size(); v += 97) {
    std::vector<Eigen::Vector3d> around;
    const auto cell = cellIndex(voxels.cells.keys[v]);
    for (std::size_t i = 0; i < scene.points.size(); ++i) {
      const auto other = cellIndex(voxels.cells.keys[voxels.cells.cell_of_point[i]]);
      if ((other - cell).cwiseAbs().maxCoeff() <= 1)
        around.push_back(scene.points[i].cast<double>());
    }
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& p : around)
      mean += p / static_cast<double>(around.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const auto& p : around)
      covariance += (p - mean) * (p - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    const auto values = solver.eigenvalues();
    // Two equal small eigenvalues have no unique direction; curvature always has.
    EXPECT_NEAR(voxels.curvatures[v], values[0] / values.sum(), 1e-5);
    if (values[1] < 1.2 * values[0])
      continue;
    const Eigen::Vector3f normal = solver.eigenvectors().col(0).cast<float>();
    EXPECT_NEAR(std::abs(voxels.normals[v].dot(normal)), 1, 1e-3);
  }
}

TEST(SurfaceVoxels, LinesAndSinglePlacesHaveNoNormal)
{
  std::vector<Eigen::Vector3f> line;
  for (int i = 0; i < 50; ++i)
    line.emplace_back(0.01f * static_cast<float>(i), 0, 0);
  auto voxels = surfaceVoxels(line, {}, 0.05);
  estimateNormals(line, voxels, 1);
  for (const auto& normal : voxels.normals)
    EXPECT_EQ(normal.norm(), 0);
}

TEST(SupervoxelGrowing, CoversAllVoxelsWithConnectedPatchesOfTheSeedSize)
{
  const auto voxels = voxelsOf(floorWithTwoBoxes());
  const auto patches = growSupervoxels(voxels, allOf(voxels), 4, {}, 1);
  for (std::uint32_t label = 0; label < patches.size(); ++label)
    EXPECT_TRUE(isConnected(voxels, patches.label_of_voxel, label));
  EXPECT_EQ(std::count(patches.label_of_voxel.begin(),
                       patches.label_of_voxel.end(),
                       Supervoxels::none),
            0);
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    const auto& centroid = patches.centroids[patches.label_of_voxel[v]];
    EXPECT_LT((centroid - voxels.centroids[v]).norm(), 2.5 * 0.12);
  }
}

TEST(SupervoxelGrowing, SeedsFartherApartThanAnyVoxelsCoverAllOfThem)
{
  const auto voxels = voxelsOf(floorWithTwoBoxes());
  for (const double seeds :
       {1e4, 1e11, 1e300}) { // 1e11 rounds are more than an int has
    const auto patches = growSupervoxels(voxels, allOf(voxels), seeds, {}, 1);
    EXPECT_EQ(patches.size(), 1u) << seeds;
    EXPECT_EQ(patches.label_of_voxel, std::vector<std::uint32_t>(voxels.size(), 0))
        << seeds;
  }
}

TEST(SupervoxelGrowing, GivesAboutAsManyAsUpstream)
{
  const auto scene = floorWithTwoBoxes();
  const auto voxels = voxelsOf(scene);
  const auto ours = growSupervoxels(voxels, allOf(voxels), 4, {}, 1);
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGBA>>();
  for (const auto& place : scene.points) {
    pcl::PointXYZRGBA point;
    point.getVector3fMap() = place;
    cloud->push_back(point);
  }
  pcl::SupervoxelClustering<pcl::PointXYZRGBA> upstream(0.03f, 0.12f);
  upstream.setInputCloud(cloud);
  upstream.setColorImportance(0);
  std::map<std::uint32_t, pcl::Supervoxel<pcl::PointXYZRGBA>::Ptr> clusters;
  upstream.extract(clusters);
  // Upstream drops seeds with few voxels around, and merges none.
  EXPECT_GT(ours.size(), 0.7 * static_cast<double>(clusters.size()));
  EXPECT_LT(ours.size(), 1.3 * static_cast<double>(clusters.size()));
}

TEST(SupervoxelGrowing, LeavesOutWhatItIsToldAndIsTheSameForAnyNumberOfThreads)
{
  const auto voxels = voxelsOf(floorWithTwoBoxes());
  std::vector<std::uint8_t> left_out(voxels.size(), 0);
  for (std::size_t v = 0; v < voxels.size(); v += 5)
    left_out[v] = 1;
  const auto one = growSupervoxels(voxels, left_out, 4, {}, 1);
  const auto two = growSupervoxels(voxels, left_out, 4, {}, 2);
  EXPECT_EQ(one.label_of_voxel, two.label_of_voxel);
  for (std::size_t v = 0; v < voxels.size(); ++v)
    EXPECT_EQ(one.label_of_voxel[v] == Supervoxels::none, left_out[v] != 0);
  EXPECT_THROW(growSupervoxels(voxels, allOf(voxels), 0.5, {}, 1),
               pcl::BadArgumentException);
  EXPECT_EQ(growSupervoxels(surfaceVoxels({}, {}, 1), {}, 4, {}, 1).size(), 0u);
}

TEST(SurfaceGraph, BendsAreSignedAnglesWithLimits)
{
  const auto at = [](float degrees) {
    const auto angle = degrees * static_cast<float>(M_PI) / 180;
    return Eigen::Vector3f(-std::sin(angle), 0, std::cos(angle));
  };
  // Two patches side by side along x; the right one rises: a valley.
  const Eigen::Vector3f left(0, 0, 0), up = at(0);
  const auto right = [&](float degrees) {
    const auto angle = degrees * static_cast<float>(M_PI) / 180;
    return Eigen::Vector3f(0.06f + 0.06f * std::cos(angle), 0, 0.06f * std::sin(angle));
  };
  EXPECT_NEAR(bendDegrees(left, up, right(0), at(0)), 0, 1e-3);
  EXPECT_NEAR(bendDegrees(left, up, right(40), at(40)), 40, 1e-3);
  EXPECT_NEAR(bendDegrees(left, up, right(90), at(90)), 60, 1e-3);
  EXPECT_NEAR(bendDegrees(left, up, right(-10), at(-10)), -10, 1e-3);
  EXPECT_NEAR(bendDegrees(left, up, right(-90), at(-90)), -20, 1e-3);
  // Turned about the connection itself the patches touch in a corner only.
  const Eigen::Vector3f turned(0, std::sin(1.0f), std::cos(1.0f));
  EXPECT_NEAR(bendDegrees(left, up, right(0), turned), 0.4f * 57.2958f, 1e-2);
}
