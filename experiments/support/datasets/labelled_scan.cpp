/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "datasets/labelled_scan.h"

#include "formats/json_text.h"

#include <algorithm>

namespace pcl::indoor::tool {

void
clearObjects(LabelledScan& scan, const std::vector<std::string>& categories)
{
  const auto& names = scan.category_names;
  std::vector<bool> is_cleared(names.size(), false);
  for (const auto& name : categories) {
    const auto found = std::find(names.begin() + 1, names.end(), name);
    if (found == names.end())
      throw ToolError("-structure: the scan has no category '" + name + "'");
    is_cleared[static_cast<std::size_t>(found - names.begin())] = true;
  }
  for (std::size_t i = 0; i < scan.categories.size(); ++i)
    if (is_cleared[scan.categories[i]])
      scan.objects[i] = 0;
}

void
appendTruth(LabelledScan& scan)
{
  if (!scan.rooms.empty())
    appendField(scan.file.cloud, "room", scan.rooms);
  appendField(scan.file.cloud, "object", scan.objects);
  if (!scan.categories.empty())
    appendField(scan.file.cloud, "category", scan.categories);
}

std::string
describeTruth(const LabelledScan& scan)
{
  nlohmann::ordered_json json;
  json["categories"] = scan.category_names;
  for (std::size_t r = 0; r < scan.room_names.size(); ++r)
    json["rooms"].push_back({{"number", r + 1}, {"name", scan.room_names[r]}});
  return jsonText(json);
}

} // namespace pcl::indoor::tool
