/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/scene_summary.h"

#include <algorithm>

namespace pcl::indoor::tool {
namespace {

std::string
counted(std::size_t count, const std::string& thing)
{
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

bool
isThing(const SceneObject& object)
{
  return object.structure == 0;
}

} // namespace

std::string
summaryOf(const Scene& scene)
{
  const auto things = static_cast<std::size_t>(
      std::count_if(scene.objects.begin(), scene.objects.end(), isThing));
  return counted(scene.building.maps.size(), "storey") + ", " +
         counted(scene.rooms.size(), "room") + ", " + counted(things, "object");
}

} // namespace pcl::indoor::tool
