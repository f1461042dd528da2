/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/scene/scene_options.h>

#include <Eigen/Core>

#include <string>

namespace pcl::indoor::tool {

/** \brief How many metres the unit has that the option -unit names; 1 if none is named.
 */
double
metresOfUnit(const std::string& name);

/** \brief The unit that has so many metres, as the option -unit names it; empty if none
 * has. */
std::string
unitName(double metres_per_unit);

/** \brief The direction that the option -up names by three numbers.
 * \throws ToolError if the text is none */
PCL_INDOOR_EXPORTS Eigen::Vector3f
upDirection(const std::string& text);

} // namespace pcl::indoor::tool
