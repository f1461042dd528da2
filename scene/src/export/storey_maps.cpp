/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/scene/storey_maps.h>

#include "export/robot_map.h"
#include "export/saved_scene.h"
#include "files/tool_error.h"
#include "text/printable.h"

#include <nlohmann/json.hpp>

namespace pcl::indoor {
namespace {

tool::SavedScene
sceneOf(const std::string& text)
{
  using Json = nlohmann::ordered_json;
  try {
    return tool::savedScene(Json::parse(text));
  } catch (const Json::exception& problem) {
    throw InputError("not a whole scene, " + tool::messageOf(problem));
  }
}

/** As nav_msgs/OccupancyGrid has it. */
std::int8_t
occupancy(std::uint8_t cell)
{
  return cell == tool::FreeCell ? 0 : cell == tool::OccupiedCell ? 100 : -1;
}

StoreyMap
storeyMap(const tool::RobotMap& robot_map, const Eigen::Affine3d& to_file, double floor)
{
  StoreyMap map;
  map.nx = robot_map.nx;
  map.ny = robot_map.ny;
  map.resolution = robot_map.resolution;
  map.lower_left_corner =
      to_file * Eigen::Vector3d(robot_map.origin.x(), robot_map.origin.y(), floor);
  map.turn = Eigen::Quaterniond(to_file.rotation());
  map.cells.reserve(robot_map.cells.size());
  for (const auto cell : robot_map.cells)
    map.cells.push_back(occupancy(cell));
  return map;
}

} // namespace

std::vector<StoreyMap>
storeyMaps(const std::string& scene, double resolution, bool with_furniture)
{
  if (!(resolution > 0.0))
    throw InputError("the side of a map's cell must be above 0 m");
  const auto saved = sceneOf(scene);
  std::vector<StoreyMap> maps;
  for (std::uint32_t s = 0; s < saved.storeys.size(); ++s)
    maps.push_back(storeyMap(tool::robotMap(saved, s, resolution, with_furniture),
                             saved.frame.uprightToFile(),
                             saved.storeys[s].floor));
  return maps;
}

} // namespace pcl::indoor
