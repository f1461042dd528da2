/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/object_segmentation.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace indoor {

/** \brief Get where the points of a single camera lie for the purpose of the voxels:
 * LCCP's transform, so that voxels grow with the distance. Empty for all other input,
 * whose points lie where they are. */
std::vector<Eigen::Vector3f>
gridPoints(const ObjectSegmentationInput& input);

/** \brief Gather the points into voxels with normals, and keep floor, walls and
 * ceiling apart from all else. */
ObjectScene
makeObjectScene(ObjectSegmentationInput input,
                const ObjectSegmentationOptions& options);

} // namespace indoor
} // namespace pcl
