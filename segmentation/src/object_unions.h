/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/object_segmentation.h>
#include <pcl/segmentation/room_structure.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** Join segments that have the shape of one thing, in two rounds. In the second, convex
 * unions take up fragments only, at most half as large: not one whole thing another. */
void
joinSegments(const SurfaceVoxels& voxels,
             const std::vector<std::uint8_t>& in_plane,
             const std::vector<StructurePlane>& planes,
             const ObjectSegmentationOptions& options,
             std::vector<std::uint32_t>& segment_of_voxel);

} // namespace indoor
} // namespace pcl
