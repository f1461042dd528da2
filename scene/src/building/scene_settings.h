/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/station_choice.h"
#include <pcl/indoor/exports.h>
#include <pcl/indoor/setting.h>
#include <pcl/scene/scene_options.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The options as scene.json records them: those of pcl_indoor_pipeline, of
 * which what shapes its other results is as it is by default.
 * \param[in] columns of the
 * scan's tables
 * \param[in] points_at_once of a scan that is read in parts; 0 of others
 */
PCL_INDOOR_EXPORTS std::vector<Setting>
settingsOf(const SceneOptions& options,
           const std::string& columns,
           const StationChoice& stations,
           std::uint64_t points_at_once);

} // namespace pcl::indoor::tool
