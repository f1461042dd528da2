/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/cloud_options.h"
#include "command_line/options.h"
#include "files/cloud_file.h"
#include "files/point_coordinates.h"
#include "formats/table/table_columns.h"

#include <pcl/features/hough_normals.h>

#include <string>

namespace pcl::indoor::tool {

/** \brief What the command line of pcl_hough_normals says. */
struct NormalSettings {
  std::string input, output;
  double radius = 0;
  int neighbors = 0;
  std::string orientation = "viewpoint", sampling = "cubes";
  HoughNormalOptions options;
  PointCoordinates coordinates;
  TableColumns columns;
  StationChoice stations;
  bool no_refinement = false;
  unsigned threads = 0;
};

/** \brief Its command line.
 * \param[in,out] settings must outlive the parser */
OptionParser
normalParser(NormalSettings& settings);

/** \brief Find out that options do not go together.
 * \throws ToolError naming them */
void
requireFitting(const NormalSettings& settings);

/** \brief The normals of the points of a file, in its order; they look to the station
 * that measured the point where the viewpoint orients them and it is known.
 * \throws ToolError if there is none */
PointCloud<Normal>
estimatedNormals(const NormalSettings& settings, const CloudFile& file);

} // namespace pcl::indoor::tool
