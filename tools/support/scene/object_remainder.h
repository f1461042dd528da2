/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "scene/room_objects.h"

namespace pcl::indoor::tool {

constexpr std::size_t fewest_object_points = 100;

/** \brief Make what is too small to be an object the remainder of its room: segments of
 * fewer points, and those that are smaller than a supervoxel.
 *
 * Their points get object 0 and structure 4; the other objects are numbered again, in
 * the same order.
 * \param[in] fewest points of an object
 */
void
separateRemainder(RoomObjects& objects, std::size_t fewest = fewest_object_points);

} // namespace pcl::indoor::tool
