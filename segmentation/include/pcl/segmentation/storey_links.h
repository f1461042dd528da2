/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/segmentation/room_map.h>
#include <pcl/segmentation/voxel_grid.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief Number the rooms of all storeys, those that reach through several ones once.
 *
 * A hall over two storeys appears on the map of each: a region of the upper map whose
 * columns are mostly open down into the space of a lower region belongs to that room.
 * \param[in] occupancy non-zero = occupied
 * \param[in] maps of the storeys, from below
 * \param[in] open_share least share of its columns that are open to the lower region,
 * 0 ... 1
 * \return per storey and label of its map the room, 1 ... n; label 0 has room 0
 */
std::vector<std::vector<std::uint32_t>>
numberRooms(const VoxelGrid<std::uint8_t>& occupancy,
            const std::vector<RoomMap>& maps,
            double open_share = 0.5);

} // namespace indoor
} // namespace pcl
