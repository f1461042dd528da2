/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pcl::indoor::tool {

/** \brief What a file tells of where its points lie. */
struct CloudPose {
  Eigen::Vector4f origin = Eigen::Vector4f::Zero();                ///< of the sensor
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity(); ///< of the sensor
  /** What has to be added to x, y, z and the origin: a comment of the file. */
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
};

} // namespace pcl::indoor::tool
