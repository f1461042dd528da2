/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "building/result_files.h"
#include "command_line/memory_limit.h"
#include "files/point_coordinates.h"
#include "files/station_choice.h"
#include "formats/table/table_columns.h"
#include "scene/point_colors.h"

#include <pcl/io/scan_file.h>
#include <pcl/scene/scene_options.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief What the command line of the pipeline says. */
struct PipelineOptions : SceneOptions, ResultOptions {
  std::vector<std::string> inputs; ///< scans of one building, or folders of them
  PointColors colors;
  PointCoordinates coordinates;
  TableColumns columns;
  StationChoice stations;
  MemoryLimit memory;
  std::uint64_t points_at_once = ScanOptions().points_at_once; ///< 0: all
  bool single_process = false;
  bool check = false; ///< no more than look at the scan
};

} // namespace pcl::indoor::tool
