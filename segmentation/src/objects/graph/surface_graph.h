/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "clustering/graph_segmentation.h"
#include "objects/graph/border_clustering.h"
#include "objects/graph/supervoxel_growing.h"

#include <vector>

namespace pcl {
namespace indoor {

/** \brief Tell whether the edge between two patches is convex (LCCP, Stein et al., CVPR
 * 2014): the surface bends away from the side of the normals, or bends little.
 * \param[in] concavity_tolerance_degrees beta_thresh: concave edges count as convex if
 * the normals differ by less
 */
bool
isConvexEdge(const Eigen::Vector3f& position_1,
             const Eigen::Vector3f& normal_1,
             const Eigen::Vector3f& position_2,
             const Eigen::Vector3f& normal_2,
             float concavity_tolerance_degrees);

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
  bool convex = false;
  std::uint32_t contacts = 0; ///< pairs of voxels that touch
};

/** \brief List the pairs of supervoxels with touching voxels, in ascending order. */
std::vector<SurfaceEdge>
surfaceEdges(const SurfaceVoxels& voxels,
             const Supervoxels& supervoxels,
             float concavity_tolerance_degrees);

/** \brief Weigh the edges: a * D^2 if convex, D if concave, Eq. (4.3) and (4.4), or
 * (2.19) where the supervoxels have an appearance with a weight.
 * \param[in] concavity_weight a, 0 to 1; lower makes convex edges stronger
 */
std::vector<WeightedEdge>
weighEdges(const Supervoxels& supervoxels,
           const std::vector<SurfaceEdge>& edges,
           const SurfaceDistance& distance,
           float concavity_weight);

/** \brief Measure the bend over each edge; the number of contacts is its length. */
std::vector<Border>
bendBorders(const Supervoxels& supervoxels, const std::vector<SurfaceEdge>& edges);

/** \brief Join patches over convex edges: the partition of LCCP. Segments of at most
 * three patches are added to their largest neighbour, as LCCP's filter does.
 * \param[in] node_count number of patches
 * \return the segment of each patch, numbered from 0 by first patch
 */
std::vector<std::uint32_t>
convexSegments(std::size_t node_count, const std::vector<SurfaceEdge>& edges);

} // namespace indoor
} // namespace pcl
