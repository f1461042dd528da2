/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "rooms/storeys/storeys.h"

#include <pcl/indoor/voxel_bits.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

constexpr double least_height = 1.0; // metres, of free space and of a scan with rooms

/** Pixels of the storeys' plans. */
struct PlaceCounts {
  std::size_t area = 0;   ///< of places, but for walls
  std::size_t places = 0; ///< those not beside walls either, where voxels hold both
  std::size_t seen = 0;   ///< with anything in their column
  std::size_t floors = 0, no_floors = 0; ///< under objects it is not known
  std::size_t ceilings = 0;
  std::size_t sides = 0; ///< of the places that were seen, those towards a wall
};

/** \brief The median of the counts that are not 0; 0 if all are. */
double
usualCount(std::vector<std::size_t> counts);

/** \brief Look at a storey from above, and count what is seen.
 * \param[in] storey of the storeys
 * \param[in,out] enclosed places with walls around them, as rooms have
 * \param[in,out] open other places where something was seen
 */
void
countPlaces(const VoxelBits& grid,
            const Storeys& storeys,
            std::size_t storey,
            PlaceCounts& enclosed,
            PlaceCounts& open);

} // namespace pcl::indoor
