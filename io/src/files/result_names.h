/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The names of the files that describe a building, in a folder of their own. */
PCL_INDOOR_EXPORTS const std::vector<std::string>&
resultNames();

/** \brief Is a file of this name a building model, GeoJSON, map or route graph of a
 * scene? */
PCL_INDOOR_EXPORTS bool
isExportName(const std::string& name);

/** \brief Is a file of this name one of the results? */
bool
isResultName(const std::string& name);

} // namespace pcl::indoor::tool
