/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/scene_file.h"

#include "scene/room_json.h"

#include <algorithm>

namespace pcl::indoor::tool {

using Json = nlohmann::ordered_json;

std::vector<SceneObject>
measureObjects(const PointCloud<PointXYZ>& points, const Scene& scene)
{
  const auto& object_of_point = scene.object_of_point;
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
    object.room = scene.room_of_point[i];
    object.structure = scene.structure_of_point[i];
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

namespace {

constexpr const char* structure_names[] = {
    "none", "floor", "wall", "ceiling", "remainder"};

/** Class, confidence and the three likeliest of an object. */
void
addClassJson(Json& json, const SceneClasses& classes, const ObjectClass& object)
{
  json["category"] = object.category;
  json["class"] = classes.names[object.category];
  json["confidence"] = rounded(static_cast<double>(object.confidence));
  json["top"] = Json::array();
  for (const auto& [category, probability] : object.top)
    json["top"].push_back({{"class", classes.names[category]},
                           {"confidence", rounded(static_cast<double>(probability))}});
}

} // namespace

std::string
sceneText(const Scene& scene,
          const CloudFile& file,
          const ScanFrame& frame,
          const std::string& parameters)
{
  std::vector<Json> objects_of_room(scene.rooms.size(), Json::array());
  Json objects = Json::array();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const auto& object = scene.objects[i];
    Json json;
    json["object"] = i + 1;
    json["room"] = object.room;
    if (object.structure > 0)
      json["structure"] = structure_names[object.structure];
    if (!scene.classes.objects.empty())
      addClassJson(json, scene.classes, scene.classes.objects[i]);
    addPlaceJson(json, object, file.offset);
    objects.push_back(std::move(json));
    if (object.room > 0)
      objects_of_room.at(object.room - 1).push_back(i + 1);
  }
  Json rooms = roomsJson(scene.rooms, scene.openings, file.offset);
  for (std::size_t i = 0; i < scene.rooms.size(); ++i)
    rooms[i]["objects"] = objects_of_room[i];
  Json json = inputJson(file, parameters, scene.room_of_point);
  addReportJson(json, frame, scene.report);
  json["storeys"] = scene.building.storeys.size();
  if (!scene.classes.names.empty())
    json["categories"] = scene.classes.names;
  json["rooms"] = std::move(rooms);
  json["objects"] = std::move(objects);
  return jsonText(json);
}

} // namespace pcl::indoor::tool
