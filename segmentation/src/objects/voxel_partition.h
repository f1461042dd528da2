/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/supervoxel_joining.h"
#include "objects/object_steps.h"

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Take out the voxels of concave and noisy regions, join supervoxels of the
 * others, and recover those that were taken out: sets all but the segments.
 * \return the segment of every voxel: that of its supervoxel, recovered, or its plane
 */
std::vector<std::uint32_t>
partitionVoxels(const ObjectSegmentationOptions& options,
                const JoinSupervoxels& join,
                DetailedSegmentation& result);

/** \brief Give each point the segment of its voxel. */
void
spreadToPoints(const std::vector<std::uint32_t>& segment_of_voxel,
               DetailedSegmentation& result);

} // namespace pcl::indoor
