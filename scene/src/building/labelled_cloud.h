/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "building/building_stages.h"
#include "files/output_file.h"
#include "files/point_coordinates.h"
#include "scene/point_colors.h"

#include <pcl/indoor/exports.h>

#include <string>

namespace pcl::indoor::tool {

/** \brief How and where a cloud is written. */
struct CloudLook {
  std::string path;
  PointColors colors;
  PointCoordinates coordinates;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ(); ///< direction of heights
  int threads = 0;                               ///< 0 = automatic
};

/** \brief Add what was found to the cloud, as it is to be written beside its place. */
PCL_INDOOR_EXPORTS OutputFile
completeCloud(const CloudLook& look, const Scene& scene, CloudFile& file);

/** \brief The same of a scan that is read in parts.
 * \param[in,out] scene gets the objects of its sample
 */
PCL_INDOOR_EXPORTS OutputFile
completeCloudInParts(const CloudLook& look,
                     const RoomFiles& files,
                     const WorkFolder& folder,
                     ScanContent& scan,
                     Scene& scene,
                     const PointsDone& report);

} // namespace pcl::indoor::tool
