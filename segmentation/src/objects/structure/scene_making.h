/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/object_scene.h"

#include <pcl/segmentation/object_segmentation.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {

/** \brief Get where the points of a single camera lie for the purpose of the voxels:
 * LCCP's transform, so that voxels grow with the distance. Empty for all other input,
 * whose points lie where they are.
 * Points beside the view, and behind the camera, are as deep as where it ends. */
std::vector<Eigen::Vector3f>
gridPoints(const ObjectSegmentationInput& input);

/** \brief All points of a scene in voxels with normals, and the floor, walls and
 * ceiling that are among them. */
struct RawScene {
  Eigen::Vector3f up;
  double voxel_size = 0; ///< metres
  SurfaceVoxels voxels;
  std::vector<StructurePlane> planes;
};

RawScene
makeRawScene(const ObjectSegmentationInput& input,
             const ObjectSegmentationOptions& options);

/** \brief Gather the points into voxels that keep floor, walls and ceiling apart from
 * all else.
 * \param[in] votes of the points; empty if nobody was asked
 * \param[in] options whose voxels may be smaller than those of the raw scene
 */
ObjectScene
makeObjectScene(ObjectSegmentationInput input,
                RawScene raw,
                const VoxelClasses& votes,
                const ObjectSegmentationOptions& options);

} // namespace pcl::indoor
