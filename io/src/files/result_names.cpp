/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/result_names.h"

#include <algorithm>
#include <regex>

namespace pcl::indoor::tool {

const std::vector<std::string>&
resultNames()
{
  static const std::vector<std::string> names = {"scene.json",
                                                 "cloud.pcd",
                                                 "rooms.png",
                                                 "potential_field.png",
                                                 "classes.png",
                                                 "plan.svg",
                                                 "plan.png",
                                                 "plan.dxf",
                                                 "report.html"};
  return names;
}

bool
isExportName(const std::string& name)
{
  static const std::regex pattern(
      R"(building\.(ifc|geojson)|map(_storey\d+)?((_furnished)?\.(pgm|yaml)|_route\.geojson))");
  return std::regex_match(name, pattern);
}

bool
isResultName(const std::string& name)
{
  const auto& names = resultNames();
  return std::find(names.begin(), names.end(), name) != names.end() ||
         isExportName(name);
}

} // namespace pcl::indoor::tool
