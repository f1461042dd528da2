/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

constexpr const char* other_class = "other"; ///< of all that no class explains

/** \brief Its number among the names of all classes; their count if it is none of them.
 */
std::uint32_t
otherClass(const std::vector<std::string>& names);

/** \brief The names of a scan's categories, from a JSON file: a list in 'categories',
 * whose positions are the numbers, or an object of number: name in 'classes'.
 * \throws ToolError if the file is missing or has neither
 */
PCL_INDOOR_EXPORTS std::map<std::uint32_t, std::string>
readCategoryNames(const std::string& path);

/** \brief The class of each category's name, from a JSON file of class: [names].
 * \throws ToolError if the file is missing, is something else or has a name twice
 */
PCL_INDOOR_EXPORTS std::map<std::string, std::string>
readClassMap(const std::string& path);

} // namespace pcl::indoor::tool
