/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/storeys/storeys.h"

#include <pcl/indoor/voxel_bits.h>
#include <pcl/indoor/voxel_map.h>

#include <cstdint>

namespace pcl::indoor {

/** \brief The columns in which the storeys below and above a level are one: halls.
 *
 * A column is high if it is free around the level, and occupied somewhere below and
 * above. A group of high columns is a hall if it is large and not narrow, as the well
 * of a stair is, or if its ceiling is too low for another storey above the level.
 * Columns of walls and of the outside go with the nearest others.
 * \return 1 in the columns of halls, else 0
 *
 * \param[in] slab not 0 where there is a slab at the level
 * \param[in] level height of the level, in voxels
 * REQUIRES: valid options.
 */
PixelMap<std::uint8_t>
openColumns(const VoxelBits& occupancy,
            const PixelMap<float>& slab,
            int level,
            const StoreyOptions& options);

} // namespace pcl::indoor
