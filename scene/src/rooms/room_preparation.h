/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/scene/scene_options.h>
#include <pcl/segmentation/room_objects.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Take the outliers out of a room, and estimate its normals.
 * \param[in,out] room z up, metres
 * \return one flag per point that was there, 1 for those that were taken out; empty if
 * none was
 */
std::vector<std::uint8_t>
prepareRoom(const RoomPreparation& preparation, RoomPoints& room);

/** \brief Give the points that were taken out no object and no structure.
 * \param[in] removed of prepareRoom()
 */
void
putBack(const std::vector<std::uint8_t>& removed, RoomObjects& objects);

} // namespace pcl::indoor::tool
