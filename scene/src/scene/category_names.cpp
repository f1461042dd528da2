/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/category_names.h"

#include "formats/json_file.h"

#include <algorithm>

namespace pcl::indoor::tool {

std::uint32_t
otherClass(const std::vector<std::string>& names)
{
  return static_cast<std::uint32_t>(std::find(names.begin(), names.end(), other_class) -
                                    names.begin());
}

std::map<std::uint32_t, std::string>
readCategoryNames(const std::string& path)
{
  return fromJsonFile(path, [&](const nlohmann::json& json) {
    std::map<std::uint32_t, std::string> names;
    if (json.contains("categories"))
      for (const auto& name : json.at("categories"))
        names.emplace(static_cast<std::uint32_t>(names.size()),
                      name.get<std::string>());
    else
      for (const auto& [number, name] : json.at("classes").items()) {
        if (number.empty() || number.size() > 9 ||
            number.find_first_not_of("0123456789") != std::string::npos)
          throw ToolError(path + ": '" + number + "' in 'classes' is no number");
        names.emplace(static_cast<std::uint32_t>(std::stoul(number)),
                      name.get<std::string>());
      }
    return names;
  });
}

std::map<std::string, std::string>
readClassMap(const std::string& path)
{
  return fromJsonFile(path, [&](const nlohmann::json& json) {
    std::map<std::string, std::string> class_of_name;
    for (const auto& [class_name, names] : json.items())
      for (const auto& name : names)
        if (!class_of_name.emplace(name.get<std::string>(), class_name).second)
          throw ToolError(path + ": '" + name.get<std::string>() +
                          "' belongs to two classes");
    return class_of_name;
  });
}

} // namespace pcl::indoor::tool
