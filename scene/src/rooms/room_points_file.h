/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/segmentation/room_objects.h>

#include <cstddef>
#include <string>

namespace pcl::indoor::tool {

/** \brief The name of the file of a room's points in a WorkFolder. */
PCL_INDOOR_EXPORTS std::string
pointsFile(std::size_t room);

/** \brief Position and, if there are some, normal of each point, one after the other.
 */
PCL_INDOOR_EXPORTS std::string
pointBytes(const RoomPoints& points);

/** \brief Read a file of such bytes.
 * \throws ToolError if it does not hold as many points
 */
PCL_INDOOR_EXPORTS RoomPoints
readRoomPoints(const std::string& path, std::size_t count, bool has_normals);

} // namespace pcl::indoor::tool
