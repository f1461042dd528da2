/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "scene/object_classes.h"

#include <pcl/ml/voxel_network.h>
#include <pcl/segmentation/room_objects.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Whether half as many points as on floors, or more, are on ceilings. */
bool
hasCeiling(const RoomObjects& objects);

/** \brief The mean of what the voxels of each object's points are.
 * \param[in] points of a room, z up, metres
 * \param[in] object_of_point from 1; 0 = none
 */
ObjectVotes
votesOf(const std::vector<Eigen::Vector3f>& points,
        const std::vector<std::uint32_t>& object_of_point,
        const VoxelNetwork& network);

/** \brief Objects that are floor, wall or ceiling by three fifths of their votes become
 * structure. What is structure remains it. */
void
nameStructure(const ObjectVotes& votes, RoomObjects& objects);

} // namespace pcl::indoor::tool
