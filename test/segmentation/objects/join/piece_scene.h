/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/join/piece_graph.h"
#include "support/labelled_points.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

namespace pcl::indoor {
namespace test {

using Labels = std::vector<std::uint32_t>;
using PieceNumbers = std::pair<std::uint32_t, std::uint32_t>;

constexpr double voxel_size = 0.03;

/** A wall that is not along the axes, after a floor. */
inline std::vector<StructurePlane>
floorAndWall(const Eigen::Matrix3d& turn)
{
  return {{turn * Eigen::Vector3d(0, 0, 1), 0, {}},
          {turn * Eigen::Vector3d(0.6, 0.8, 0), -3, {}},
          {turn * Eigen::Vector3d(1, 0, 0), -3, {}}};
}

/** All that pieces are made of, and that it stands for; without points. */
struct Scene : ObjectScene {
  Labels piece_of_voxel;
  Supervoxels supervoxels;
  std::vector<SurfaceEdge> edges;
  std::uint32_t piece_count = 0;
  VoxelClasses votes;

  PieceGraph
  graph() const
  {
    return pieceGraph({*this, piece_of_voxel, piece_count, supervoxels, edges, votes},
                      roomFrame(*this));
  }

  /** Give each supervoxel a piece, the planes the last one. */
  template <typename PieceOf>
  void
  setPieces(std::uint32_t count, PieceOf piece_of)
  {
    piece_count = count + 1;
    piece_of_voxel.assign(voxels.size(), count);
    for (std::size_t v = 0; v < voxels.size(); ++v)
      if (plane_of_voxel[v] == 0)
        piece_of_voxel[v] = piece_of(supervoxels.label_of_voxel[v]);
  }
};

inline const Eigen::Matrix3f leaning =
    Eigen::AngleAxisf(0.7f, Eigen::Vector3f(1, 2, -0.5f).normalized())
        .toRotationMatrix();

/** Two boxes on a floor, 6 cm apart, one of them higher; supervoxels of 12 cm. */
inline Scene
twoBoxes(const Eigen::Matrix3f& turn = Eigen::Matrix3f::Identity())
{
  std::mt19937 rng(3);
  test::LabelledPoints points;
  points.addRectangle(
      {0, 0, 0}, {1.2f, 0, 0}, {0, 0.8f, 0}, {0, 0, 1}, 1, 0.015f, 0.003f, rng);
  points.addBox({0.1f, 0.2f, 0}, {0.4f, 0.3f, 0.25f}, 2, 0.015f, 0.003f, rng);
  points.addBox({0.56f, 0.2f, 0}, {0.3f, 0.4f, 0.4f}, 3, 0.015f, 0.003f, rng);
  for (auto* vectors : {&points.points, &points.normals})
    for (auto& vector : *vectors)
      vector = turn * vector;
  Scene scene;
  scene.voxels = surfaceVoxels(points.points, {}, voxel_size);
  estimateNormals(points.points, scene.voxels, 1);
  averageNormals(points.normals, scene.voxels);
  std::vector<std::uint8_t> left_out;
  for (const auto& centroid : scene.voxels.centroids)
    left_out.push_back((turn.transpose() * centroid).z() < 0.02f);
  scene.plane_of_voxel.assign(left_out.begin(), left_out.end());
  scene.supervoxels = growSupervoxels(scene.voxels, left_out, 4, {}, 1);
  scene.edges = surfaceEdges(scene.voxels, scene.supervoxels);
  scene.planes = floorAndWall(turn.cast<double>());
  scene.up = turn.col(2);
  return scene;
}

inline Eigen::Matrix3f
frameOf(const Scene& scene)
{
  Eigen::Matrix3d frame; // the floor is no wall, so the second plane counts
  frame.row(2) = scene.up.cast<double>();
  frame.row(0) = scene.planes[1].normal;
  frame.row(1) = scene.up.cast<double>().cross(scene.planes[1].normal);
  return frame.cast<float>();
}

/** One place per voxel, all normals alike, no supervoxels; the first place is of a
 * plane. */
inline Scene
sceneOf(const std::vector<std::pair<Eigen::Vector3f, std::uint32_t>>& places,
        std::uint32_t piece_count,
        const Eigen::Vector3f& normal)
{
  Scene scene;
  std::vector<Eigen::Vector3f> points;
  for (const auto& place : places)
    points.push_back(place.first);
  scene.voxels = surfaceVoxels(points, {}, voxel_size);
  scene.voxels.normals.assign(scene.voxels.size(), normal);
  scene.plane_of_voxel.assign(scene.voxels.size(), 0);
  if (!places.empty())
    scene.plane_of_voxel[scene.voxels.cells.cell_of_point[0]] = 1;
  scene.piece_of_voxel.assign(scene.voxels.size(), 0);
  for (std::size_t i = 0; i < places.size(); ++i)
    scene.piece_of_voxel[scene.voxels.cells.cell_of_point[i]] = places[i].second;
  scene.piece_count = piece_count;
  scene.supervoxels.label_of_voxel.assign(scene.voxels.size(), Supervoxels::none);
  return scene;
}

inline void
expectNear(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double tolerance)
{
  ASSERT_EQ(a.rows(), b.rows());
  EXPECT_LE((a - b).cwiseAbs().maxCoeff(), tolerance) << a << "\nis not\n" << b;
}

inline void
expectNear(const VectorMoments& a, const VectorMoments& b)
{
  EXPECT_DOUBLE_EQ(a.count, b.count);
  expectNear(a.sum, b.sum, 1e-9 + 1e-6 * b.count);
  expectNear(a.squares, b.squares, 1e-9 + 1e-6 * b.count);
}

} // namespace test
} // namespace pcl::indoor
