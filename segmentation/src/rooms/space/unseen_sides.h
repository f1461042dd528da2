/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/space/interior_space.h"

#include <pcl/indoor/voxel_bits.h>
#include <pcl/indoor/voxel_map.h>

#include <cstdint>

namespace pcl::indoor {

/** \brief Tell whether a scan shows floors and ceilings, and where they are missing.
 *
 * Walls end at the floor and at the ceiling. So a little above their lower and a little
 * below their upper ends, where walls stand on both sides in all directions, something
 * lies below and above. Linear in the number of columns.
 * \param[in] occupancy not 0 = occupied
 * \param[in] bits result of enclosure()
 * \param[in] direction_count number of directions that were given to enclosure()
 */
UnseenSides
findUnseenSides(const VoxelMap<std::uint8_t>& occupancy,
                const VoxelMap<std::uint8_t>& bits,
                int direction_count);

/** \brief Put floors and ceilings where they are missing.
 * \param[in] space that they are missing in
 * \param[in,out] grid that \a space was made of; filled-in voxels are set
 */
void
closeUnseenSides(const InteriorSpace& space, VoxelBits& grid);

} // namespace pcl::indoor
