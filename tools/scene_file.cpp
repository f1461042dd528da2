/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace pcl::indoor::tool {
namespace {

using Json = nlohmann::ordered_json;

/** Tenths of a millimetre: finer than any scanner, and short to read. */
double
rounded(double metres)
{
  return std::round(metres * 1e4) / 1e4;
}

Json
positionJson(const Eigen::Vector3d& position)
{
  return {rounded(position.x()), rounded(position.y()), rounded(position.z())};
}

template <typename Thing>
void
addPlace(Json& json, const Thing& thing, const Eigen::Vector3d& offset)
{
  json["points"] = thing.point_count;
  json["box"] = {{"lower", positionJson(thing.lower + offset)},
                 {"upper", positionJson(thing.upper + offset)}};
  json["centroid"] = positionJson(thing.centroid + offset);
}

} // namespace

std::vector<SceneObject>
measureObjects(const PointCloud<PointXYZ>& points,
               const std::vector<std::uint32_t>& room_of_point,
               const std::vector<std::uint32_t>& object_of_point)
{
  std::vector<SceneObject> objects(
      object_of_point.empty()
          ? 0
          : *std::max_element(object_of_point.begin(), object_of_point.end()));
  for (std::size_t i = 0; i < object_of_point.size(); ++i) {
    if (object_of_point[i] == 0)
      continue;
    auto& object = objects[object_of_point[i] - 1];
    const Eigen::Vector3d point = points[i].getVector3fMap().cast<double>();
    if (object.point_count == 0)
      object.lower = object.upper = point;
    object.room = room_of_point[i];
    object.lower = object.lower.cwiseMin(point);
    object.upper = object.upper.cwiseMax(point);
    object.centroid += point;
    ++object.point_count;
  }
  for (auto& object : objects)
    if (object.point_count > 0)
      object.centroid /= static_cast<double>(object.point_count);
  return objects;
}

std::string
sceneText(const Scene& scene, const CloudFile& file, const std::string& parameters)
{
  std::vector<Json> objects_of_room(scene.rooms.size(), Json::array());
  Json objects = Json::array();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const auto& object = scene.objects[i];
    Json json;
    json["object"] = i + 1;
    json["room"] = object.room;
    addPlace(json, object, file.offset);
    objects.push_back(std::move(json));
    if (object.room > 0)
      objects_of_room.at(object.room - 1).push_back(i + 1);
  }
  Json rooms = Json::array();
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    const auto& room = scene.rooms[i];
    Json json;
    json["room"] = room.label;
    json["storey"] = room.storey;
    addPlace(json, room, file.offset);
    json["area"] = rounded(room.area);
    json["height"] = rounded(room.height);
    json["volume"] = rounded(room.volume);
    json["objects"] = objects_of_room[i];
    rooms.push_back(std::move(json));
  }
  const auto in_room = static_cast<std::size_t>(std::count_if(
      scene.room_of_point.begin(), scene.room_of_point.end(), [](std::uint32_t room) {
        return room > 0;
      }));
  Json json;
  json["input"] = std::filesystem::path(file.path).filename().string();
  json["parameters"] = parameters;
  json["unit"] = "metre";
  json["points"] = file.points->size();
  json["finite_points"] = file.finite_count;
  json["points_in_rooms"] = in_room;
  json["storeys"] = scene.building.storeys.size();
  json["rooms"] = std::move(rooms);
  json["objects"] = std::move(objects);
  // file names need not be UTF-8
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace pcl::indoor::tool
