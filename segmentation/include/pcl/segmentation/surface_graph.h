/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/border_clustering.h>
#include <pcl/segmentation/graph_segmentation.h>
#include <pcl/segmentation/supervoxel_growing.h>

#include <vector>

namespace pcl {
namespace indoor {

/** \brief Criteria of LCCP for the edge between two patches (Stein et al., CVPR 2014).
 */
struct ConvexityOptions {
  /** beta_thresh: concave edges count as convex if the normals differ by less; degrees
   */
  float concavity_tolerance_degrees = 10.0f;
  /** Reject edges between patches that touch in a single place only. */
  bool use_sanity_check = false;
  /** Reject edges over a step between two surfaces. */
  bool use_smoothness_check = false;
  float smoothness_threshold = 0.1f; ///< step that is tolerated, in voxels
  double voxel_size = 0.03;          ///< metres
  double seed_size = 0.12;           ///< metres
};

/** \brief Tell whether the edge between two patches is convex.
 * The connection is convex if the surface bends away from the side of the normals, or
 * bends little.
 */
bool
isConvexEdge(const Eigen::Vector3f& position_1,
             const Eigen::Vector3f& normal_1,
             const Eigen::Vector3f& position_2,
             const Eigen::Vector3f& normal_2,
             const ConvexityOptions& options);

/** \brief How the bend between two patches counts against joining them. */
struct BendOptions {
  float convex_limit_degrees = 20;  ///< convex bends count no more than this (0 to 180)
  float concave_limit_degrees = 60; ///< nor concave ones more than this (0 to 180)
  /** share of the bend that counts as concave where patches touch in one place only, so
   * that LCCP's criterion is not defined (0 to 1) */
  float singular_share = 0.4f;
};

/** \brief Measure the bend between two patches, positive for concave.
 * Zero where the surface is flat; noise of the normals averages out over a border.
 * \return degrees, from -convex_limit_degrees to concave_limit_degrees
 */
float
bendDegrees(const Eigen::Vector3f& position_1,
            const Eigen::Vector3f& normal_1,
            const Eigen::Vector3f& position_2,
            const Eigen::Vector3f& normal_2,
            const BendOptions& options);

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
             const ConvexityOptions& options);

/** \brief Weigh the edges: a * D^2 if convex, D if concave, Eq. (4.3) and (4.4).
 * \param[in] concavity_weight a, 0 to 1; lower makes convex edges stronger
 */
std::vector<WeightedEdge>
weighEdges(const Supervoxels& supervoxels,
           const std::vector<SurfaceEdge>& edges,
           const SurfaceDistance& distance,
           float concavity_weight);

/** \brief Measure the bend over each edge; the number of contacts is its length. */
std::vector<Border>
bendBorders(const Supervoxels& supervoxels,
            const std::vector<SurfaceEdge>& edges,
            const BendOptions& options);

/** \brief Join patches over convex edges: the partition of LCCP.
 * \param[in] node_count number of patches
 * \param[in] common_neighbors a convex edge joins only if its patches have this many
 * common neighbours with convex edges to both (k of extended convexity; 0 for all)
 * \param[in] min_segment_size segments of at most this many patches are added to their
 * largest neighbour, as LCCP's filter does (n_filter, 0 for none)
 * \return the segment of each patch, numbered from 0 by first patch
 */
std::vector<std::uint32_t>
convexSegments(std::size_t node_count,
               const std::vector<SurfaceEdge>& edges,
               unsigned common_neighbors,
               unsigned min_segment_size);

} // namespace indoor
} // namespace pcl
