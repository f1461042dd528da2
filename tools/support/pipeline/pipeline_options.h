/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/memory_limit.h"
#include "files/point_coordinates.h"
#include "formats/table_columns.h"
#include "rooms/room_preparation.h"
#include "scene/point_colors.h"
#include "scene/scan_frame.h"

#include <pcl/segmentation/building_rooms.h>
#include <pcl/segmentation/object_segmentation.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief What the command line of the pipeline says. */
struct PipelineOptions {
  std::vector<std::string> inputs; ///< scans of one building, or folders of them
  std::string folder;
  std::string partition = "graph";
  std::string preset = "default";
  std::string model = "bundled"; ///< file, "none" or "bundled"
  std::string report = "folder"; ///< file, "none" or "folder"
  ScanFrame frame;
  RoomPreparation preparation;
  BuildingRoomsOptions rooms;
  ObjectSegmentationOptions objects;
  double voxel_resolution = 0.0,
         seed_resolution = 0.0; ///< of the objects, 0 = automatic
  PointColors colors;
  PointCoordinates coordinates;
  TableColumns columns;
  MemoryLimit memory;
  int threads = 0;
  std::uint64_t points_at_once = 20000000; ///< 0: all
  bool ignore_normals = false;
  bool single_process = false;
  bool check = false; ///< no more than look at the scan

  std::string
  reportFile() const
  {
    return report == "folder" ? folder + "/report.html" : report;
  }
};

} // namespace pcl::indoor::tool
