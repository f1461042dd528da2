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

/** \brief What is recorded beside SceneOptions: how the scan was read, and what the
 * results of pcl_indoor_pipeline are written as. */
struct FileSettings {
  std::string columns; ///< of the scan's tables
  StationChoice stations;
  std::uint64_t points_at_once = 0; ///< of a scan that is read in parts; 0 of others
  std::string report = "folder";
  std::string colour = "auto";
  bool doubles = false;
};

/** \brief The options as scene.json records them: those of pcl_indoor_pipeline. */
PCL_INDOOR_EXPORTS std::vector<Setting>
settingsOf(const SceneOptions& options, const FileSettings& files);

} // namespace pcl::indoor::tool
