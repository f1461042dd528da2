/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/scene_json.h"

#include <pcl/scene/room_names.h>
#include <pcl/scene/scene_file.h>

#include "files/output_file.h"
#include "formats/json_text.h"
#include "scene/model_json.h"
#include "scene/room_json.h"
#include "scene/segmented_rooms.h"
#include "scene/understood_scan.h"
#include "text/program_version.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format_version = 2;
constexpr const char* structure_names[] = {"none", "floor", "wall", "ceiling"};

Json
settingsJson(const std::vector<Setting>& settings)
{
  Json json;
  for (const auto& setting : settings) {
    auto& value = json[setting.name.substr(1)]; // without the dash
    if (setting.kind == Setting::Kind::Number)
      value = Json::parse(setting.value);
    else if (setting.kind == Setting::Kind::Flag)
      value = setting.value == "on";
    else
      value = setting.value;
  }
  return json;
}

/** Where the directions of the building's frame, whose z is up, lie in the file's. */
Json
axesJson(const Scene& scene)
{
  const auto direction = [&scene](int column) {
    return positionJson(scene.frame.pose.linear().col(column));
  };
  return {{"x", direction(0)}, {"y", direction(1)}, {"up", direction(2)}};
}

/** Storeys from below; heights in metres along the up axis, in the file's frame. */
Json
storeysJson(const Scene& scene)
{
  const double base = scene.frame.originInFile().z();
  Json storeys = Json::array();
  for (std::size_t s = 0; s < scene.building.maps.size(); ++s) {
    const auto& heights = scene.building.heights.at(s);
    Json rooms = Json::array();
    double area = 0.0;
    for (const auto& room : scene.rooms)
      if (room.storey == s) {
        rooms.push_back(room.label);
        area += room.area;
      }
    storeys.push_back({{"storey", s},
                       {"floor", rounded(heights.floor + base)},
                       {"ceiling", rounded(heights.ceiling + base)},
                       {"area", rounded(area)},
                       {"rooms", std::move(rooms)}});
  }
  return storeys;
}

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

/** \param[in] to_file brings a place of the upright frame into the file's */
Json
uprightJson(const UprightBox& box, const Eigen::Affine3d& to_file)
{
  return {{"center", positionJson(to_file * box.center)},
          {"size", positionJson(box.size)},
          {"yaw_degrees", rounded(box.yaw * 180.0 / M_PI)}};
}

/** What a room is for, and the three likeliest names. */
void
addNameJson(const NamedRoom& named, Json& room)
{
  std::vector<std::pair<double, RoomName>> names;
  for (std::size_t n = 0; n < room_name_count; ++n)
    names.emplace_back(named.probabilities[n], static_cast<RoomName>(n));
  std::stable_sort(names.begin(), names.end(), [](const auto& a, const auto& b) {
    return a.first > b.first;
  });
  names.resize(3);
  room["name"] = named.text();
  room["name_probability"] = rounded(named.probability());
  room["name_top"] = Json::array();
  for (const auto& [probability, name] : names)
    room["name_top"].push_back(
        {{"name", nameOf(name)}, {"probability", rounded(probability)}});
}

/** Adds to each room what it is for. */
void
addNamesToRooms(Json& rooms, const Scene& scene)
{
  const auto named = roomNames(scene);
  for (std::size_t i = 0; i < named.size() && i < rooms.size(); ++i)
    addNameJson(named[i], rooms[i]);
}

Json
objectsJson(const Scene& scene)
{
  const auto to_file = scene.frame.uprightToFile();
  Json objects = Json::array();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const auto& object = scene.objects[i];
    Json json;
    json["object"] = i + 1;
    json["room"] = object.room;
    if (object.room > 0)
      json["storey"] = scene.rooms.at(object.room - 1).storey;
    json["structure"] = structure_names[object.structure];
    if (!scene.classes.names.empty())
      addClassJson(json, scene.classes, scene.classes.objects[i]);
    addPlaceJson(json, object, scene.frame.offset);
    json["upright_box"] = uprightJson(object.upright, to_file);
    objects.push_back(std::move(json));
  }
  return objects;
}

/** Adds to each room its objects, and how they were looked for. */
void
addObjectsToRooms(Json& rooms, const Scene& scene)
{
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    auto& room = rooms[i];
    room["voxel_resolution"] = rounded(scene.object_voxels.at(i));
    room["seed_resolution"] = rounded(scene.seeds_per_voxel * scene.object_voxels[i]);
    room["remainder"] = scene.remainders.at(i);
    room["objects"] = Json::array();
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (scene.objects[i].room > 0)
      rooms[scene.objects[i].room - 1]["objects"].push_back(i + 1);
}

} // namespace

Json
sceneJson(const Scene& scene)
{
  Json json = {
      {"format", "pcl_indoor scene"},
      {"version", format_version},
      {"program", {{"name", "pcl_indoor_pipeline"}, {"version", programVersion()}}}};
  json.update(inputJson(scene.input));
  json["points"] = scene.counts.all;
  json["finite_points"] = scene.counts.finite;
  json["points_in_rooms"] = scene.counts.in_rooms;
  json["settings"] = settingsJson(scene.settings);
  json["axes"] = axesJson(scene);
  addReportJson(json, scene.report, scene.counts.outside);
  json["overview"] = overviewJson(scene.understood);
  json["remainder_in_no_room"] = scene.remainders.back();
  json["storeys"] = storeysJson(scene);
  if (!scene.classes.names.empty())
    json["categories"] = scene.classes.names;
  json["rooms"] = roomsJson(scene.rooms, scene.openings, scene.frame.offset);
  addNamesToRooms(json["rooms"], scene);
  addObjectsToRooms(json["rooms"], scene);
  const auto to_file = scene.frame.buildingToFile();
  json["walls"] = wallsJson(scene.model, to_file);
  json["columns"] = columnsJson(scene.model, to_file);
  json["openings"] = openingsJson(scene.model, to_file);
  json["objects"] = objectsJson(scene);
  return json;
}

} // namespace pcl::indoor::tool

namespace pcl::indoor {

std::string
sceneText(const Scene& scene)
{
  return tool::jsonText(tool::sceneJson(scene));
}

void
saveScene(const std::string& path, const Scene& scene)
{
  tool::saveText(path, sceneText(scene));
}

} // namespace pcl::indoor
