/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "segmentation/objects/join/piece_scene.h"

#include <cmath>
#include <limits>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

/** What stands for up, and the floor's height in it. */
void
expectFrame(const PieceFrame& frame, const Eigen::Vector3f& up, double floor)
{
  expectNear(frame.axes * frame.axes.transpose(), Eigen::Matrix3d::Identity(), 1e-6);
  EXPECT_NEAR(frame.axes.determinant(), 1, 1e-6);
  expectNear(frame.axes.row(2).transpose(), up.cast<double>(), 0.02);
  EXPECT_NEAR(frame.floor, floor, 0.01);
}

} // namespace

TEST(PieceFrame, ARoomHasItsFirstWall)
{
  const auto scene = twoBoxes(leaning);
  const auto frame = roomFrame(scene);
  expectFrame(frame, scene.up, 0);
  expectNear(frame.axes.row(0).transpose(), scene.planes[1].normal, 1e-6);
  EXPECT_EQ(frame.voxel_size, voxel_size);
}

TEST(PieceFrame, AViewHasItsLargestPiece)
{
  auto scene = twoBoxes(leaning); // a floor of 0.96 square metres and smaller boxes
  const Eigen::Vector3f height = 0.5f * scene.up;
  for (auto& centroid : scene.voxels.centroids)
    centroid += height;
  Labels piece_of_voxel;
  for (const auto plane : scene.plane_of_voxel)
    piece_of_voxel.push_back(plane != 0 ? 1 : 0);
  for (std::size_t v = 0; v < piece_of_voxel.size(); ++v)
    if (piece_of_voxel[v] == 0 && v % 2 == 0)
      piece_of_voxel[v] = 2;
  scene.up = {0, 0, 1}; // does not count
  float nearest = std::numeric_limits<float>::infinity(), farthest = -nearest;
  for (const auto& centroid : scene.voxels.centroids) {
    nearest = std::min(nearest, centroid.z());
    farthest = std::max(farthest, centroid.z());
  }
  const float camera = nearest - 2;
  const auto frame = viewFrame(scene, piece_of_voxel, 3, {7, 7, camera});
  expectFrame(frame, leaning.col(2), 0.5);
  EXPECT_GT(frame.voxel_size, voxel_size * 2);
  EXPECT_LT(frame.voxel_size, voxel_size * (farthest - camera));
}

TEST(PieceFrame, NothingHasTheFrameOfItsDirectionUp)
{
  Scene scene;
  scene.up = Eigen::Vector3f(0, 0.6f, 0.8f);
  scene.voxel_size = 0.1;
  for (const auto& frame : {roomFrame(scene), viewFrame(scene, {}, 0, {0, 0, 0})}) {
    expectFrame(frame, scene.up, 0);
    EXPECT_EQ(frame.voxel_size, 0.1);
  }
}
