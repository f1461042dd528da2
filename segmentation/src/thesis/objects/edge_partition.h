/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/surface_graph.h"
#include "thesis/objects/graph_segmentation.h"

#include <pcl/segmentation/thesis.h>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** n_filter of LCCP (Sec. 4.3.2): segments of so many patches, or fewer, are small. */
constexpr std::uint32_t largest_small_segment = 3;

/** \brief Flag the edges that are convex (LCCP, Stein et al., CVPR 2014): the surface
 * bends away from the side of the normals, or bends little.
 * \param[in] concavity_tolerance_degrees beta_thresh: concave edges count as convex if
 * the normals differ by less
 */
std::vector<std::uint8_t>
convexEdges(const Supervoxels& supervoxels,
            const std::vector<SurfaceEdge>& edges,
            float concavity_tolerance_degrees);

/** \brief Weigh the edges: a * D^2 if convex, D if concave, Eq. (4.3) and (4.4), or
 * (2.19) where the supervoxels have an appearance with a weight.
 * \param[in] is_convex one flag per edge
 * \param[in] concavity_weight a, 0 to 1; lower makes convex edges stronger
 */
std::vector<WeightedEdge>
weighEdges(const Supervoxels& supervoxels,
           const std::vector<SurfaceEdge>& edges,
           const std::vector<std::uint8_t>& is_convex,
           const SurfaceDistance& distance,
           float concavity_weight);

/** \brief Join patches over convex edges: the partition of LCCP. Segments of at most
 * three patches are added to their largest neighbour, as LCCP's filter does.
 * \param[in] node_count number of patches
 * \param[in] is_convex one flag per edge
 * \return the segment of each patch, numbered from 0 by first patch
 */
std::vector<std::uint32_t>
convexSegments(std::size_t node_count,
               const std::vector<SurfaceEdge>& edges,
               const std::vector<std::uint8_t>& is_convex);

namespace thesis {

/** \brief Eq. (4.4) or (2.19) with the weights of the options. */
SurfaceDistance
distanceOf(const ObjectOptions& options);

/** \brief Join supervoxels by the partition of the options.
 * \return the segment of each supervoxel, numbered from 0 */
std::vector<std::uint32_t>
joinOverEdges(const Supervoxels& supervoxels,
              const std::vector<SurfaceEdge>& edges,
              const ObjectOptions& options);

} // namespace thesis
} // namespace pcl::indoor
