/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "building/scene_settings.h"

#include "text/number_text.h"

namespace pcl::indoor::tool {
namespace {

template <typename T>
Setting
number(const std::string& name, T value, const std::string& unit)
{
  return {name, numberText(value), unit, Setting::Kind::Number};
}

Setting
text(const std::string& name, const std::string& value)
{
  return {name, value.empty() ? "none" : value, "", Setting::Kind::Text};
}

Setting
flag(const std::string& name, bool value)
{
  return {name, value ? "on" : "off", "", Setting::Kind::Flag};
}

} // namespace

std::vector<Setting>
settingsOf(const SceneOptions& options, const FileSettings& files)
{
  const auto& rooms =
      options.thesis_rooms ? options.thesis_rooms->shared : options.rooms;
  std::vector<Setting> settings = {
      number("-voxel_size", rooms.voxel_size, "m"),
      number("-min_area", rooms.map.min_area, "m^2"),
      number("-voxel_resolution", options.voxel_resolution, "m"),
      number("-seed_resolution", options.seed_resolution, "m"),
      text("-preset", options.preset),
      text("-partition", options.partition),
      text("-model", options.naming.classify ? "function" : options.model),
      text("-network", options.network),
      text("-report", files.report)};
  if (files.points_at_once > 0)
    settings.push_back(number("-points_at_once", files.points_at_once, "points"));
  const auto others = {flag("-ignore_normals", options.ignore_normals),
                       text("-normals", options.preparation.normals),
                       flag("-remove_outliers", options.preparation.removes_outliers),
                       text("-colour", files.colour),
                       flag("-double", files.doubles),
                       text("-columns", files.columns),
                       text("-stations", files.stations.file),
                       flag("-ignore_stations", files.stations.is_ignored),
                       text("-unit", options.scan.unit),
                       text("-up", options.scan.up)};
  settings.insert(settings.end(), others.begin(), others.end());
  return settings;
}

} // namespace pcl::indoor::tool
