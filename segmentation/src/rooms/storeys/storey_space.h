/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/space/interior_space.h"
#include "rooms/storeys/storeys.h"

#include <pcl/indoor/voxel_bits.h>

#include <cstddef>

namespace pcl::indoor {

/** \brief The z range of a storey in a grid: voxels begin ... end - 1. */
struct VerticalRange {
  int begin = 0;
  int end = 0;
};

/** \brief The part of a building's voxels that makes up one storey.
 * A slab thinner than a voxel belongs to both storeys: it is the ceiling of the one and
 * the floor of the other.
 */
struct StoreySpace {
  VoxelBits occupancy;    ///< the layers of the storey; set = occupied
  int first_layer = 0;    ///< layer of the building's grid that is layer 0 here
  VerticalRange range;    ///< layers from the typical floor to the highest ceiling
  InteriorSpace interior; ///< the same part of the coarser voxels
};

/** \brief Cut one storey out of a building's voxels.
 * \param[in] occupancy of the whole building
 * \param[in] interior of the same
 * \param[in] storeys of the same
 * \param[in] storey 0 = the lowest; less than storeys.heights.size()
 */
StoreySpace
storeySpace(const VoxelBits& occupancy,
            const InteriorSpace& interior,
            const Storeys& storeys,
            std::size_t storey);

} // namespace pcl::indoor
