/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/model/room_names.h>
#include <pcl/scene/scene.h>

#include <vector>

namespace pcl::indoor {

/** \brief What a scene tells of its rooms: sizes, doors, windows, objects.
 *
 * Doors to the outside as wide as two leaves are taken for glass, too; wider ones are
 * gates.
 * \return one per room
 */
PCL_INDOOR_EXPORTS std::vector<RoomEvidence>
roomEvidence(const Scene& scene);

/** \brief Tell what the rooms of a scene are for, see nameRooms().
 * \return one per room
 */
PCL_INDOOR_EXPORTS std::vector<NamedRoom>
roomNames(const Scene& scene);

} // namespace pcl::indoor
