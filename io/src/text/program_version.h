/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <string>

namespace pcl::indoor::tool {

/** \brief The version of this project, for example "0.1.0". */
PCL_INDOOR_EXPORTS std::string
programVersion();

} // namespace pcl::indoor::tool
