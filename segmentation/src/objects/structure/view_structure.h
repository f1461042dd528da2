/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/objects/room_structure.h>

namespace pcl {
namespace indoor {

/** \brief Find floor, ceiling and walls in a camera's view of a room.
 *
 * As findRoomStructure(), but a view ends anywhere: a plane also counts if at least 90
 * % of all that is seen lies before it. \param[in] voxels with normals that face the
 * camera \throws pcl::BadArgumentException if the voxel size is not positive
 */
std::vector<StructurePlane>
findViewStructure(const SurfaceVoxels& voxels, double voxel_size);

} // namespace indoor
} // namespace pcl
