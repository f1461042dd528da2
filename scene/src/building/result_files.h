/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/output_file.h"

#include <pcl/indoor/exports.h>
#include <pcl/scene/scene.h>

#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Where the results go, and what else there is of them. */
struct ResultOptions {
  std::string folder;
  std::string report = "folder";                  ///< file, "none" or "folder"
  bool ifc = false, map = false, geojson = false; ///< written besides
  int epsg = 0; ///< of the scan's coordinates; 0 = not known

  std::string
  reportFile() const
  {
    return report == "folder" ? folder + "/report.html" : report;
  }
};

/** \brief Find out, before the long work, what cannot be written.
 * \throws ToolError naming it */
PCL_INDOOR_EXPORTS void
requireWritableResults(const ResultOptions& options);

using NamedBytes = std::vector<std::pair<std::string, std::string>>;

/** \brief The files beside the cloud, by their paths; scene.json is the last.
 * \param[in] points of the scene, z up, metres
 */
PCL_INDOOR_EXPORTS NamedBytes
describe(const ResultOptions& options,
         const Scene& scene,
         const PointCloud<PointXYZ>& points);

/** \brief Put all results into the folder. */
PCL_INDOOR_EXPORTS void
save(const std::string& folder, const NamedBytes& texts, OutputFile cloud);

/** \brief The names of all results, for a person. */
PCL_INDOOR_EXPORTS std::string
namesOf(const NamedBytes& texts);

} // namespace pcl::indoor::tool
