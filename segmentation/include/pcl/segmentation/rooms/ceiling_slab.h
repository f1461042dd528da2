/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_bits.h>
#include <pcl/indoor/voxel_map.h>

#include <cstdint>

namespace pcl {
namespace indoor {

/** \brief Where the walls of a storey are looked for: in a slab right below the
 * ceiling.
 *
 * Furniture seldom reaches the ceiling; walls and the lintels over doorways do. So the
 * slab shows the rooms closed, where a map of the whole height shows them cluttered and
 * joined by their doors.
 */
struct CeilingSlabOptions {
  double window =
      1.0;           ///< side of the square in which the ceiling is looked for, metres
  double step = 0.6; ///< how far a column's own top may lie below the highest top in
                     ///< the window and still be its ceiling, metres
  double level_share =
      0.3;                 ///< or share of the columns there that are as high as itself
  double min_height = 1.8; ///< a ceiling is at least so high above the floor, metres
  double gap = 0.15;       ///< least distance from the ceiling to the slab, metres
  double max_gap = 0.6;    ///< greatest distance, where noise blurs the ceiling, metres
  double min_wall = 0.5;   ///< shorter things in the slab are no walls, metres
  double depth = 0.3;      ///< height of the slab, metres
};

/** \brief The z range of a storey in a grid: voxels begin ... end - 1. */
struct VerticalRange {
  int begin = 0;
  int end = 0;
};

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
PixelMap<int>
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

/** \brief Free the connected parts (8 neighbours) that are too small for a wall: noise,
 * lamps, pillars.
 * \param[in,out] blocked 1 = blocked, 0 = free
 * \param[in] min_extent parts whose box is smaller than this along x and y are freed,
 * pixels
 */
void
removeSpecks(PixelMap<std::uint8_t>& blocked, int min_extent);

} // namespace indoor
} // namespace pcl
