/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/memory_limit.h"
#include "command_line/options.h"
#include "files/point_coordinates.h"
#include "formats/table/table_columns.h"
#include "scene/point_colors.h"
#include "scene/segmented_objects.h"

#include <pcl/scene/scene_options.h> // for CoordinateOptions
#include <pcl/segmentation/thesis.h>

#include <cstdint>
#include <string>

namespace pcl::indoor::tool {

/** \brief What the command line sets; 0 in lengths, angles and sizes stands for the
 * preset's value. */
struct ObjectSettings {
  std::string input, output;
  std::string preset = "auto", partition = "auto", camera = "auto";
  std::string orientation = "auto";
  double level = -1;
  std::uint32_t min_segment = 0;
  double voxel_resolution = 0, seed_resolution = 0;
  bool ignore_normals = false, remove_outliers = false;
  ObjectSegmentationOptions others;
  thesis::EdgeOptions edges;      // for partitions without pieces
  thesis::PointOptions on_points; // for the thesis's presets
  PointColors colors;
  PointCoordinates coordinates;
  TableColumns columns;
  MemoryLimit memory;
  CoordinateOptions scan;
};

/** \brief The defaults, of the preset that the command line names. */
ObjectSettings
objectSettings(int argc, const char* const* argv);

/** \brief All options. */
void
addOptions(OptionParser& parser, ObjectSettings& settings);

/** \brief Find out that options do not go together.
 * \throws ToolError naming one that does not */
void
requireFitting(const ObjectSettings& settings);

/** \brief What they say for the search.
 * \param[in] settings must outlive it */
ObjectChoices
choicesOf(const ObjectSettings& settings);

} // namespace pcl::indoor::tool
