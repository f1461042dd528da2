/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_grid.h>
#include <pcl/segmentation/rooms/storeys.h>

#include <cstdint>

namespace pcl {
namespace indoor {

/** \brief Where two storeys are not divided at a level: 1 in the columns of halls.
 *
 * A column is high if it is free around the level, between something occupied below and
 * above. High columns are a hall if they are many and not close to the slab on both
 * sides (stairs), or if their ceiling is too close for a storey above. Columns of walls
 * and outside go with the nearest others.
 *
 * \param[in] slab not 0 where there is a slab at the level
 * \param[in] level height of the level, in voxels
 * REQUIRES: valid options, as many values as voxels.
 */
PixelMap<std::uint8_t>
openColumns(const VoxelGrid<std::uint8_t>& occupancy,
            const PixelMap<float>& slab,
            int level,
            const StoreyOptions& options);

} // namespace indoor
} // namespace pcl
