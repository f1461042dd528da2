/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/border_clustering.h"
#include "objects/graph/supervoxel_growing.h"

#include <vector>

namespace pcl::indoor {

/** \brief The angle between two directions, degrees; 0 if one has no length. */
float
angleDegrees(const Eigen::Vector3f& a, const Eigen::Vector3f& b);

/** \brief Measure the bend between two patches: the angle between their normals,
 * positive where concave, negative where convex. It is 0 where the surface is flat, so
 * that noise of the normals averages out over a border. Convex bends count at most 20
 * degrees, concave ones at most 60. Where LCCP cannot tell convex from concave (its
 * sanity criterion), 0.4 of the angle counts as concave.
 * \return degrees, from -20 to 60
 */
float
bendDegrees(const Eigen::Vector3f& position_1,
            const Eigen::Vector3f& normal_1,
            const Eigen::Vector3f& position_2,
            const Eigen::Vector3f& normal_2);

/** \brief Two patches that touch. */
struct SurfaceEdge {
  std::uint32_t source = 0; ///< the smaller label
  std::uint32_t target = 0;
  std::uint32_t contacts = 0; ///< pairs of voxels that touch
};

/** \brief List the pairs of supervoxels with touching voxels, in ascending order. */
std::vector<SurfaceEdge>
surfaceEdges(const SurfaceVoxels& voxels, const Supervoxels& supervoxels);

/** \brief Measure the bend over each edge; the number of contacts is its length. */
std::vector<Border>
bendBorders(const Supervoxels& supervoxels, const std::vector<SurfaceEdge>& edges);

} // namespace pcl::indoor
