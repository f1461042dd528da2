/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/surface_graph.h"

#include <pcl/segmentation/object_segmentation.h>

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace pcl::indoor {

/** \brief Tells the segment of each supervoxel, numbered from 0. */
using JoinSupervoxels = std::function<std::vector<std::uint32_t>(
    const Supervoxels& supervoxels, const std::vector<SurfaceEdge>& edges)>;

/** \brief Eq. (4.4) with the weights of the options. */
SurfaceDistance
distanceOf(const ObjectSegmentationOptions& options);

/** \brief Join supervoxels to pieces: over borders that bend little.
 * \param[in] min_segment_size C, supervoxels */
std::vector<std::uint32_t>
joinByBends(const Supervoxels& supervoxels,
            const std::vector<SurfaceEdge>& edges,
            std::uint32_t min_segment_size);

/** \brief segmentSupervoxels() by a way of joining. */
std::map<std::uint32_t, std::uint32_t>
joinNamed(const NamedSupervoxels& given, const JoinSupervoxels& join);

} // namespace pcl::indoor
