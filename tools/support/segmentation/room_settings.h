/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/memory_limit.h"
#include "command_line/options.h"
#include "files/point_coordinates.h"
#include "files/station_choice.h"
#include "formats/table/table_columns.h"
#include "scene/point_colors.h"

#include <pcl/scene/scene_options.h> // for CoordinateOptions
#include <pcl/segmentation/room_segmentation.h>

#include <string>

namespace pcl::indoor::tool {

/** \brief What the command line of pcl_room_segmentation says. */
struct RoomSettings {
  std::string input, output, map, json, dxf;
  std::string method = "slab", preset = "default";
  CoordinateOptions scan;
  thesis::RoomOptions rooms; // with -method slab its shared options
  PointColors colors;
  PointCoordinates coordinates;
  TableColumns columns;
  StationChoice stations;
  MemoryLimit memory;
  bool check = false;
};

/** \brief The defaults, of the preset that the command line names. */
RoomSettings
roomSettings(int argc, const char* const* argv);

/** \brief Check the options.
 * \throws ToolError naming the input, if one is none */
void
requireLegal(const RoomSettings& options);

/** \brief A segmentation by the method that was chosen. */
RoomSegmentation<PointXYZ>
segmentationBy(const RoomSettings& options);

/** \brief Its command line.
 * \param[in,out] options must outlive the parser */
OptionParser
roomParser(RoomSettings& options);

} // namespace pcl::indoor::tool
