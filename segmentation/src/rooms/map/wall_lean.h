/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/map/room_map.h"

#include <pcl/indoor/voxel_bits.h>
#include <pcl/indoor/voxel_map.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief A lean less than this moves a wall by less than a voxel over the height of a
 * storey. */
constexpr double least_lean = 0.04;

/** \brief A stretch of wall, seen from above. */
struct WallStretch {
  Eigen::Vector2d place;  ///< its middle in the slab, pixels
  Eigen::Vector2d normal; ///< horizontal unit vector across it
  double lean = 0.0;      ///< shift along the normal per unit of height, going down
  double weight = 0.0;    ///< inverse variance of the lean, in voxels
};

/** \brief Measure how much the walls below a slab lean.
 *
 * Walls are found in the slab below the ceiling. For each stretch of one the lean is
 * taken that gathers its occupied voxels, from the slab to the floor, best in the
 * vertical section across the wall, and a line is fitted to those near it. So furniture
 * and the curve of a vault do not matter as long as most of the wall is straight; below
 * lintels there is no stretch. Linear in the length of walls.
 * \param[in] occupancy of a storey; set = occupied
 * \param[in] map of the storey: its range, ceiling, slab and what is blocked
 */
std::vector<WallStretch>
wallStretches(const VoxelBits& occupancy, const RoomMap& map, int threads = 0);

/** \brief The shift along x and y, per unit of height going down, of what stands around
 * each pixel: a least-squares fit to the walls within about a metre. One wall tells
 * only the shift across itself; at a corner two walls tell both components.
 * \param[in] nx, ny size of the map
 * \param[in] pixel_size metres
 * \return nothing (no values) if all stretches are upright
 */
PixelMap<Eigen::Vector2f>
leanMap(const std::vector<WallStretch>& stretches, int nx, int ny, double pixel_size);

/** \brief The height of the slab's middle over each pixel, in layers; where there is no
 * ceiling, that below the storey's highest layer. */
PixelMap<float>
slabHeights(const RoomMap& map);

/** \brief Where something would be at the height of the slab if it stood upright.
 * \param[in] lean as leanMap() gives it
 * \param[in] slab as slabHeights() gives it
 * \param[in] place where it is, in pixels and layers
 */
Eigen::Vector2d
straightened(const PixelMap<Eigen::Vector2f>& lean,
             const PixelMap<float>& slab,
             const Eigen::Vector3d& place);

/** \brief The columns that would hold something if all stood upright: 1, others 0.
 * \param[in] occupancy of a storey; set = occupied
 */
PixelMap<std::uint8_t>
straightenedColumns(const VoxelBits& occupancy,
                    const PixelMap<Eigen::Vector2f>& lean,
                    const PixelMap<float>& slab);

} // namespace pcl::indoor
