/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/scene_summary.h"

#include "text/printable.h"

#include <algorithm>
#include <map>
#include <utility>

namespace pcl::indoor::tool {
namespace {

std::string
counted(std::size_t count, const std::string& noun)
{
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

bool
isObject(const SceneObject& object)
{
  return object.structure == 0;
}

TextTable
storeyTable(const Scene& scene)
{
  TextTable table({"storey>", "rooms>", "area, m^2>", "objects>"});
  for (std::size_t s = 0; s < scene.building.maps.size(); ++s) {
    std::size_t rooms = 0;
    double area = 0.0;
    for (const auto& room : scene.rooms)
      if (room.storey == s) {
        ++rooms;
        area += room.area;
      }
    const auto objects = std::count_if(
        scene.objects.begin(), scene.objects.end(), [&](const SceneObject& object) {
          return isObject(object) && object.room > 0 &&
                 scene.rooms[object.room - 1].storey == s;
        });
    table.add({std::to_string(s),
               std::to_string(rooms),
               fixedText(area, 1),
               std::to_string(objects)});
  }
  return table;
}

TextTable
classTable(const Scene& scene)
{
  std::map<std::string, std::size_t> counts;
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (isObject(scene.objects[i]))
      ++counts[scene.classes.names[scene.classes.objects[i].category]];
  std::vector<std::pair<std::string, std::size_t>> sorted(counts.begin(), counts.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return a.second > b.second;
  });
  TextTable table({"class", "objects>"});
  for (const auto& [name, count] : sorted)
    table.add({name, std::to_string(count)});
  return table;
}

} // namespace

std::string
summaryOf(const Scene& scene)
{
  const auto object_count = static_cast<std::size_t>(
      std::count_if(scene.objects.begin(), scene.objects.end(), isObject));
  return counted(scene.building.maps.size(), "storey") + ", " +
         counted(scene.rooms.size(), "room") + ", " + counted(object_count, "object");
}

std::vector<TextTable>
tablesOf(const Scene& scene)
{
  std::vector<TextTable> tables = {storeyTable(scene)};
  if (!scene.classes.names.empty())
    tables.push_back(classTable(scene));
  return tables;
}

} // namespace pcl::indoor::tool
