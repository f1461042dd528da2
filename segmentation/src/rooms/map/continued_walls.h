/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>

#include <cstdint>

namespace pcl::indoor {

/** \brief Walls that were seen up to the ceiling in parts go on where less of their
 * height was seen.
 *
 * Along the rows and columns of the map, which lie along the walls: a line without a
 * gap, three pixels wide for walls that are rough or drift, is a wall where at least a
 * metre of it, and 0.3 of its length, reaches up. Shelves that stand free do not, doors
 * are gaps.
 *
 * \param[in] high pixels that are blocked up to the ceiling, 1 = blocked, 0 = free
 * \param[in] low those that are blocked up to the heads of people; same size
 * \param[in] pixel_size metres
 * \return high, and the pixels of low in such lines
 */
PixelMap<std::uint8_t>
continuedWalls(const PixelMap<std::uint8_t>& high,
               const PixelMap<std::uint8_t>& low,
               double pixel_size);

} // namespace pcl::indoor
