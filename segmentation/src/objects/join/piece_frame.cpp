/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/join/piece_frame.h"

#include "objects/structure/camera_view.h"

#include <pcl/indoor/ground_frame.h>
#include <pcl/indoor/quantile.h>

#include <algorithm>

namespace {

constexpr double lowest_share = 0.005; // of all voxels, below the floor's height

} // namespace

namespace pcl::indoor {

PieceFrame
roomFrame(const ObjectScene& scene)
{
  PieceFrame frame{groundFrame(scene.up), 0, scene.voxel_size};
  const Eigen::Vector3d z = scene.up.cast<double>();
  for (const auto& plane : scene.planes) {
    const Eigen::Vector3d across = plane.normal - plane.normal.dot(z) * z;
    if (across.norm() < 0.7)
      continue;
    frame.axes.row(0) = across.normalized();
    frame.axes.row(1) = z.cross(across).normalized();
    break;
  }
  std::vector<double> heights;
  heights.reserve(scene.voxels.size());
  const Eigen::RowVector3f up = frame.axes.row(2).cast<float>();
  for (const auto& centroid : scene.voxels.centroids)
    heights.push_back(up.dot(centroid));
  if (!heights.empty())
    frame.floor = quantile(heights, lowest_share);
  return frame;
}

PieceFrame
viewFrame(const ObjectScene& scene,
          const std::vector<std::uint32_t>& piece_of_voxel,
          std::uint32_t piece_count,
          const Eigen::Vector3f& viewpoint)
{
  PieceFrame frame{groundFrame(scene.up), 0, scene.voxel_size};
  if (scene.voxels.size() == 0)
    return frame;
  std::vector<std::uint32_t> sizes(piece_count, 0);
  for (const auto piece : piece_of_voxel)
    ++sizes[piece];
  const auto support = static_cast<std::uint32_t>(
      std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  std::vector<float> distances;
  distances.reserve(scene.voxels.size());
  for (std::size_t v = 0; v < scene.voxels.size(); ++v) {
    distances.push_back(scene.voxels.centroids[v].z() - viewpoint.z());
    if (piece_of_voxel[v] == support)
      normal += scene.voxels.normals[v].cast<double>();
  }
  if (normal.norm() > 0)
    frame.axes = groundFrame(normal.normalized().cast<float>());
  std::vector<double> heights;
  for (std::size_t v = 0; v < scene.voxels.size(); ++v)
    if (piece_of_voxel[v] == support)
      heights.push_back(
          frame.axes.row(2).dot(scene.voxels.centroids[v].cast<double>()));
  frame.floor = median(heights);
  frame.voxel_size *= std::max(median(distances), least_camera_distance);
  return frame;
}

} // namespace pcl::indoor
