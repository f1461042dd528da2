/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/storeys/storey_space.h" // for VerticalRange

#include <pcl/indoor/exports.h>
#include <pcl/indoor/voxel_bits.h>
#include <pcl/indoor/voxel_map.h>
#include <pcl/segmentation/building_rooms_options.h>

#include <cstdint>

namespace pcl::indoor {

/** \brief The layer of the ceiling over every map pixel.
 * A column with an occupied voxel close to the highest one of its surroundings has its
 * ceiling there (so slopes are followed), and so has one whose own top makes a level
 * with many others (a low ceiling beside a high one). Over other columns, where the
 * ceiling was not seen, the highest one of the surroundings is taken; where none was
 * seen at all, the storey's highest layer.
 * \param[in] occupancy set = occupied
 * \param[in] storey the layers that count
 * \return the layer, or -1 where the surroundings hold no occupied voxel
 */
PCL_INDOOR_EXPORTS PixelMap<int>
ceilingLayers(const VoxelBits& occupancy,
              const VerticalRange& storey,
              const CeilingSlabOptions& options);

/** \brief The layers below a column's ceiling that make the slab: first ... last. */
struct SlabLayers {
  int first = 0;
  int last = 0;
};

/** \brief Put the slab below the ceiling as noise, slope and lamps leave it.
 * Counts how many columns are occupied so many layers below their ceiling: at the
 * ceiling nearly all, farther down only those of the walls. The slab begins where this
 * share has come down.
 * \param[in] ceiling as ceilingLayers() gives it
 */
SlabLayers
slabLayers(const VoxelBits& occupancy,
           const VerticalRange& storey,
           const PixelMap<int>& ceiling,
           const CeilingSlabOptions& options);

/** \brief The columns in which something stands in the slab and goes on up to the
 * ceiling, as walls and lintels do.
 * A column is blocked if it has an occupied voxel in the slab from which to the ceiling
 * no two layers in a row are free in all 3 x 3 columns around it.
 * \param[in] ceiling as ceilingLayers() gives it; pixels without ceiling are not
 * blocked
 * \param[in] slab as slabLayers() gives it
 * \return 1 = blocked, 0 = free
 */
PixelMap<std::uint8_t>
blockedColumns(const VoxelBits& occupancy,
               const VerticalRange& storey,
               const PixelMap<int>& ceiling,
               const SlabLayers& slab);

/** \brief The layers below which walls are looked for where no ceiling was seen.
 * Walls that a lidar sees from nearby are seen for a part of their height. Where less
 * of them is seen right above the heads of people (min_height) than right below, no
 * layer is more than 1.6 m above the floor; else these are the layers of the ceiling.
 *
 * \param[in] ceiling as ceilingLayers() gives it
 */
PixelMap<int>
seenTops(const VoxelBits& occupancy,
         const VerticalRange& storey,
         const PixelMap<int>& ceiling,
         const CeilingSlabOptions& options);

/** \brief The layers below which walls reach up to the heads of people: no more than
 * 1.6 m above the floor.
 * \param[in] ceiling as ceilingLayers() gives it
 */
PixelMap<int>
topsAtHeads(const VoxelBits& occupancy,
            const VerticalRange& storey,
            const PixelMap<int>& ceiling);

/** \brief Free the connected parts (8 neighbours) that are too small for a wall: noise,
 * lamps, pillars.
 * \param[in,out] blocked 1 = blocked, 0 = free
 * \param[in] min_extent parts whose box is smaller than this along x and y are freed,
 * pixels
 */
void
removeSpecks(PixelMap<std::uint8_t>& blocked, int min_extent);

} // namespace pcl::indoor
