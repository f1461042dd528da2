/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <string>

namespace pcl::indoor {
namespace tool {

/** \brief Read a place that is given as X,Y,Z.
 * \param[in] option that it was given to, for the message
 * \throws ToolError if it is none
 */
PCL_INDOOR_EXPORTS Eigen::Vector3d
readPlace(const std::string& option, const std::string& text);

} // namespace tool
} // namespace pcl::indoor
