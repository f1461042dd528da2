/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/surface_graph.h"

#include <pcl/segmentation/object_segmentation.h>

#include <cstdint>
#include <map>
#include <vector>

namespace pcl {
namespace indoor {

/** Eq. (4.4) or (2.19) with the weights of the options. */
SurfaceDistance
distanceOf(const ObjectSegmentationOptions& options);

/** \brief Join supervoxels by the partition of the options.
 * \return the segment of each supervoxel, numbered from 0 */
std::vector<std::uint32_t>
joinSupervoxels(const Supervoxels& supervoxels,
                const std::vector<SurfaceEdge>& edges,
                const ObjectSegmentationOptions& options);

} // namespace indoor
} // namespace pcl
