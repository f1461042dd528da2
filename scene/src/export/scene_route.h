/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "export/saved_scene.h"

#include <pcl/indoor/exports.h>

#include <nlohmann/json.hpp>

#include <string>

namespace pcl::indoor::tool {

/** \brief The shortest way between two places of a scene: its length, metres, and the
 * steps on it, each with its kind, number, room and storey, the place in the frame and
 * the unit of the scan's file, and the way so far.
 * \param[in] ends FROM:TO, each the number of a room or X,Y,Z in that frame
 * \throws ToolError if they are none, in no room, or no way leads from one to the other
 */
PCL_INDOOR_EXPORTS nlohmann::ordered_json
sceneRoute(const SavedScene& scene, const std::string& ends);

} // namespace pcl::indoor::tool
