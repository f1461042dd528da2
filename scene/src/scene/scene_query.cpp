/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/scene_query.h"

#include "files/tool_error.h"
#include "formats/json_text.h" // for rounded
#include "scene/coordinate_options.h"
#include "text/printable.h"

#include <pcl/model/room_names.h>
#include <pcl/segmentation/building_frame.h>
#include <pcl/segmentation/room_objects.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace pcl::indoor::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr int deepest = 100; // lists in lists: to copy and write them needs the stack

Eigen::Vector3d
vectorOf(const Json& json)
{
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

/** Of the file whose places a scene tells. */
BuildingFrame
frameOf(const Json& scene)
{
  const auto& axes = scene.at("axes");
  BuildingFrame frame;
  frame.metres_per_unit = metresOfUnit(scene.at("coordinate_unit").get<std::string>());
  frame.pose.linear() << vectorOf(axes.at("x")), vectorOf(axes.at("y")),
      vectorOf(axes.at("up"));
  return frame;
}

/** From a place in the file's frame to an object's box, metres. */
double
distanceTo(const Json& object, const Eigen::Vector3d& place, const BuildingFrame& frame)
{
  const auto& json = object.at("upright_box");
  UprightBox box; // around the origin
  box.size = vectorOf(json.at("size"));
  box.yaw = json.at("yaw_degrees").get<double>() * M_PI / 180.0;
  return distanceTo(box, frame.scanToUpright(place - vectorOf(json.at("center"))));
}

double
longestSide(const Json& object)
{
  return vectorOf(object.at("upright_box").at("size")).maxCoeff();
}

bool
isWantedRoom(const Json& room, const SceneQuery& query)
{
  return (!query.room || room.at("room") == *query.room) &&
         (!query.storey || room.at("storey") == *query.storey) &&
         (query.room_name.empty() || room.value("name", "") == query.room_name);
}

bool
isInRoomOfName(const Json& object, const Json& scene, const std::string& name)
{
  if (name.empty())
    return true;
  const auto room = object.at("room").get<std::size_t>();
  return room > 0 && scene.at("rooms").at(room - 1).value("name", "") == name;
}

bool
isWanted(const Json& object, const SceneQuery& query)
{
  const double size = longestSide(object);
  return (query.with_structure || object.at("structure") == "none") &&
         (query.object_class.empty() ||
          object.value("class", "") == query.object_class) &&
         (!query.room || object.at("room") == *query.room) &&
         (!query.storey ||
          (object.contains("storey") && object["storey"] == *query.storey)) &&
         size >= query.min_size && size <= query.max_size;
}

void
requireKnownName(const std::string& name)
{
  std::string known;
  for (std::size_t n = 0; n < room_name_count; ++n) {
    const std::string each = nameOf(static_cast<RoomName>(n));
    if (each == name)
      return;
    known += each + ", ";
  }
  if (!name.empty() && name != "unknown")
    throw ToolError("-room_name: '" + name + "' is not one of " + known + "unknown");
}

/** A room, storey or class that is not there is a mistake, not an empty answer. */
void
requireKnown(const Json& scene, const SceneQuery& query)
{
  const auto has = [&scene](const char* list, const char* key, std::uint32_t number) {
    const auto& items = scene.at(list);
    return std::any_of(items.begin(), items.end(), [&](const Json& item) {
      return item.at(key) == number;
    });
  };
  if (query.room && *query.room > 0 && !has("rooms", "room", *query.room))
    throw ToolError("-room: there is no room " + std::to_string(*query.room));
  if (query.storey && !has("storeys", "storey", *query.storey))
    throw ToolError("-storey: there is no storey " + std::to_string(*query.storey));
  requireKnownName(query.room_name);
  if (query.object_class.empty())
    return;
  if (!scene.contains("categories"))
    throw ToolError("-class: the scene has no classes");
  std::string known;
  for (const auto& name : scene["categories"]) {
    if (name == query.object_class)
      return;
    if (name != "none")
      known += (known.empty() ? "" : ", ") + name.get<std::string>();
  }
  throw ToolError("-class: '" + query.object_class + "' is not one of " + known);
}

std::string
joined(const Json& numbers, const char* between)
{
  std::string text;
  for (const auto& number : numbers)
    text += (text.empty() ? "" : between) + fixedText(number.get<double>(), 2);
  return text;
}

} // namespace

Json
readScene(const std::string& path)
{
  std::ifstream stream(path);
  if (!stream)
    throw ToolError(path + ": cannot be read");
  try {
    auto scene = Json::parse(stream, [&path](int depth, Json::parse_event_t, Json&) {
      if (depth > deepest)
        throw ToolError(path + ": lists are nested more than " +
                        std::to_string(deepest) + " deep");
      return true;
    });
    if (!scene.is_object() || scene.value("format", "") != "pcl_indoor scene")
      throw ToolError(path + ": not a scene, as pcl_indoor_pipeline writes it");
    if (scene.at("version") != 1 && scene["version"] != 2)
      throw ToolError(path + ": a scene of version " + scene["version"].dump() +
                      ", but only 1 and 2 can be read");
    return scene;
  } catch (const Json::exception& problem) {
    throw ToolError(path + ": " + messageOf(problem));
  }
}

std::vector<Json>
matchingRooms(const Json& scene, const SceneQuery& query)
{
  requireKnown(scene, query);
  std::vector<Json> rooms;
  for (const auto& room : scene.at("rooms"))
    if (isWantedRoom(room, query))
      rooms.push_back(room);
  return rooms;
}

std::vector<Json>
matchingObjects(const Json& scene, const SceneQuery& query)
{
  requireKnown(scene, query);
  const auto frame = frameOf(scene);
  std::vector<std::pair<double, const Json*>> found;
  for (const auto& object : scene.at("objects"))
    if (isWanted(object, query) && isInRoomOfName(object, scene, query.room_name))
      found.emplace_back(
          query.nearest ? distanceTo(object, *query.nearest, frame) : 0.0, &object);
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return a.first < b.first;
  });
  if (query.count > 0 && found.size() > query.count)
    found.resize(query.count);
  std::vector<Json> objects;
  for (const auto& [metres, object] : found) {
    objects.push_back(*object);
    if (query.nearest)
      objects.back()["distance"] = rounded(metres);
  }
  return objects;
}

TextTable
objectTable(const std::vector<Json>& objects, bool with_distances)
{
  std::vector<std::string> header = {
      "object>", "class", "sure>", "room>", "storey>", "size, m>", "centre>"};
  if (with_distances)
    header.emplace_back("distance, m>");
  TextTable table(header);
  for (const auto& object : objects) {
    const bool is_object = object.at("structure") == "none";
    const auto name = object.value("class", "-");
    const auto& box = object.at("upright_box");
    std::vector<std::string> row = {
        object.at("object").dump(),
        is_object ? name : object["structure"].get<std::string>(),
        is_object && object.contains("confidence")
            ? fixedText(100.0 * object["confidence"].get<double>(), 0) + " %"
            : "-",
        object.at("room") == 0 ? "-" : object["room"].dump(),
        object.contains("storey") ? object["storey"].dump() : "-",
        joined(box.at("size"), " x "),
        joined(box.at("center"), ", ")};
    if (with_distances)
      row.push_back(fixedText(object.at("distance").get<double>(), 2));
    table.add(row);
  }
  return table;
}

TextTable
roomTable(const std::vector<Json>& rooms)
{
  TextTable table({"room>", "name", "sure>", "storey>", "area, m^2>", "height, m>"});
  for (const auto& room : rooms)
    table.add({room.at("room").dump(),
               room.value("name", "-"),
               room.contains("name_probability")
                   ? fixedText(100.0 * room["name_probability"].get<double>(), 0) + " %"
                   : "-",
               room.at("storey").dump(),
               fixedText(room.at("area").get<double>(), 2),
               fixedText(room.at("height").get<double>(), 2)});
  return table;
}

TextTable
routeTable(const Json& route)
{
  TextTable table({"step", "number>", "room>", "storey>", "place", "way, m>"});
  for (const auto& step : route.at("steps"))
    if (step["kind"] != "corner")
      table.add({step["kind"].get<std::string>(),
                 step.contains("number") ? step["number"].dump() : "-",
                 step.contains("room") ? step["room"].dump() : "-",
                 step["storey"].dump(),
                 joined(step["position"], ", "),
                 fixedText(step["distance"].get<double>(), 2)});
  return table;
}

} // namespace pcl::indoor::tool
