/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/object_segmentation.h>
#include <pcl/segmentation/objects/room_structure.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** Voxels with normals; floor, walls and ceiling are apart from all else.
 * \return floor, walls and ceiling */
std::vector<StructurePlane>
makeObjectVoxels(const ObjectSegmentationInput& input,
                 const ObjectSegmentationOptions& options,
                 ObjectSegmentation& result);

/** Flags of the voxels in planes of floor, walls and ceiling. */
std::vector<std::uint8_t>
inStructure(const ObjectSegmentation& result);

/** Eq. (4.2) for voxels: the points of the voxels around are counted.
 * \param[in] in_plane flags of voxels that are not looked at */
std::vector<std::uint8_t>
findNonConvexVoxels(const SurfaceVoxels& voxels,
                    const std::vector<std::uint8_t>& in_plane,
                    const ObjectSegmentationOptions& options);

} // namespace indoor
} // namespace pcl
