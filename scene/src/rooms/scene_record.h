/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "rooms/finished_room.h"
#include "scene/scene_json.h"

#include <pcl/indoor/exports.h>

#include <optional>
#include <string>

namespace pcl::indoor::tool {

/** \brief Drop what only the search for rooms needs: the grids. What pictures, plans
 * and scene.json are made of stays. */
void
dropGrids(BuildingRooms& building);

/** \brief The rooms of a scene as bytes, after dropGrids(); without its objects. */
PCL_INDOOR_EXPORTS std::string
sceneBytes(const Scene& scene);

/** \brief The scene of such bytes; nothing if they are damaged. */
PCL_INDOOR_EXPORTS std::optional<Scene>
sceneOf(const std::string& bytes);

/** \brief A finished room as bytes. */
PCL_INDOOR_EXPORTS std::string
roomBytes(const FinishedRoom& room);

/** \brief The room of such bytes; nothing if they are damaged. */
PCL_INDOOR_EXPORTS std::optional<FinishedRoom>
roomOf(const std::string& bytes);

} // namespace pcl::indoor::tool
