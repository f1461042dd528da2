/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "scene/object_classes.h"

#include <pcl/segmentation/room_objects.h>

namespace pcl::indoor::tool {

/** \brief The mean of what the voxels of each object's points are, without the names of
 * the classes.
 * \param[in] objects with votes */
ObjectVotes
votesOf(const RoomObjects& objects);

} // namespace pcl::indoor::tool
