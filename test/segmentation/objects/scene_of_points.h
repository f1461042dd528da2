/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/object_scene.h"

#include <vector>

namespace pcl::indoor {
namespace test {

/** A scene without structure, whose voxels have no normals. */
inline ObjectScene
sceneOfPoints(const std::vector<Eigen::Vector3f>& points, double voxel_size)
{
  ObjectScene scene;
  scene.points = points;
  scene.voxel_size = voxel_size;
  scene.voxels = surfaceVoxels(points, {}, voxel_size);
  scene.voxels.normals.assign(scene.voxels.size(), Eigen::Vector3f::Zero());
  scene.plane_of_voxel.assign(scene.voxels.size(), 0);
  return scene;
}

} // namespace test
} // namespace pcl::indoor
