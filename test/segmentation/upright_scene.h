/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "support/object_scene.h"

#include <pcl/segmentation/upright_unions.h>

namespace pcl {
namespace indoor {
namespace test {

constexpr float voxel_size = 1.0f / 32; // places and their sums have no rounding
const Eigen::Vector3f along_x(1, 0, 0), along_y(0, 1, 0), along_z(0, 0, 1);

/** Full voxels from one to before another, with the normal of a surface. */
inline void
addBlock(LabelledPoints& scene,
         const Eigen::Array3i& first,
         const Eigen::Array3i& end,
         const Eigen::Vector3f& normal,
         std::uint32_t object)
{
  for (int x = 2 * first.x(); x < 2 * end.x(); ++x)
    for (int y = 2 * first.y(); y < 2 * end.y(); ++y)
      for (int z = 2 * first.z(); z < 2 * end.z(); ++z) {
        scene.points.push_back(voxel_size / 2 * Eigen::Array3i(x, y, z).cast<float>());
        scene.normals.push_back(normal.normalized());
        scene.objects.push_back(object);
      }
}

/** A desk top (1) of 1.25 m x 0.625 m whose underside is 0.625 m high. */
inline LabelledPoints
deskTop()
{
  LabelledPoints scene;
  addBlock(scene, {0, 0, 20}, {40, 20, 21}, along_z, 1);
  return scene;
}

inline UprightUnionOptions
voxelOptions()
{
  UprightUnionOptions options;
  options.voxel_size = voxel_size;
  return options;
}

inline SurfaceVoxels
voxelsOf(const LabelledPoints& scene)
{
  auto voxels = surfaceVoxels(scene.points, {}, voxel_size);
  averageNormals(scene.normals, voxels);
  return voxels;
}

/** The segments of the points after uprights are joined; before, those of the scene.
 * Objects from first_left_out on are left out. */
inline std::vector<std::uint32_t>
joined(const LabelledPoints& scene,
       const UprightUnionOptions& options = voxelOptions(),
       std::uint32_t first_left_out = 100)
{
  const auto voxels = voxelsOf(scene);
  std::vector<std::uint32_t> segments(voxels.size(), 0), labels;
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    segments[voxels.cells.cell_of_point[i]] = scene.objects[i];
  std::vector<std::uint8_t> left_out;
  for (const auto segment : segments)
    left_out.push_back(segment >= first_left_out);
  joinUprights(voxels, left_out, options, segments);
  for (const auto voxel : voxels.cells.cell_of_point)
    labels.push_back(segments[voxel]);
  return labels;
}

inline std::size_t
countOf(const LabelledPoints& scene,
        const UprightUnionOptions& options = voxelOptions())
{
  return segmentCount(joined(scene, options));
}

} // namespace test
} // namespace indoor
} // namespace pcl
