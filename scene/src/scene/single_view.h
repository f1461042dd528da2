/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/noise_resilient_lccp.h>

namespace pcl::indoor {
namespace tool {

/** \brief Whether a cloud is one camera's view of a table, as pcl::NoiseResilientLCCP
 * takes it. */
inline bool
isSingleView(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud)
{
  pcl::NoiseResilientLCCP<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  return segmentation.getUseSingleCameraTransform();
}

} // namespace tool
} // namespace pcl::indoor
