/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "export/saved_scene.h"

#include <pcl/indoor/exports.h>

#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {

/** \brief How a scene is written for other programs. */
struct ExportOptions {
  int epsg = 0;             ///< code of the scan's coordinate system; 0 = not known
  double resolution = 0.05; ///< side of a map's cell, metres
};

/** \brief The files that are written under a name, which says the format: .ifc, .glb,
 * .geojson, .dxf, .svg, or .pgm, which stands for the maps and route graphs of all
 * storeys. With their bytes; the file of that name is the last.
 * \throws ToolError naming the file, if its format is none of these
 */
PCL_INDOOR_EXPORTS std::vector<std::pair<std::string, std::string>>
exportedFiles(const SavedScene& scene,
              const std::string& path,
              const ExportOptions& options);

/** \brief Find out, before any work, that the format is none of these. */
PCL_INDOOR_EXPORTS void
requireExportFormat(const std::string& path);

} // namespace pcl::indoor::tool
