/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/scene_description.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace pcl::indoor {

namespace {

using Json = nlohmann::ordered_json;

double
millimetres(double value)
{
  return std::round(value * 1000) / 1000;
}

template <typename Vector>
Json
listOf(const Vector& vector)
{
  Json list = Json::array();
  for (Eigen::Index i = 0; i < vector.size(); ++i)
    list.push_back(millimetres(vector[i]));
  return list;
}

Json
describeRoom(const Building& building, std::size_t index)
{
  const auto& room = building.rooms[index];
  Json json;
  json["number"] = index + 1;
  json["name"] = room.name;
  if (!room.kind.empty())
    json["kind"] = room.kind;
  json["storey"] = room.storey;
  json["storey_name"] = room.storey_name;
  json["floor"] = millimetres(room.floor);
  json["area"] = millimetres(signedArea(room.polygon));
  json["polygon"] = Json::array();
  for (const auto& vertex : room.polygon)
    json["polygon"].push_back(
        listOf(Eigen::Vector2d(vertex + room.floor * building.lean)));
  return json;
}

Json
describeObject(const ObjectInfo& object, std::size_t number)
{
  Json json;
  json["number"] = number;
  json["room"] = object.room;
  json["category"] = object.category;
  json["position"] = listOf(object.position);
  json["size"] = listOf(object.size);
  json["rotation"] = millimetres(object.rotation * 180 / M_PI);
  json["parts"] = Json::array();
  for (std::size_t i = 0; i < object.part_names.size(); ++i)
    json["parts"].push_back(
        {{"number", object.first_part + i}, {"name", object.part_names[i]}});
  return json;
}

// One element per line: readable, and short enough to compare.
std::string
linesOf(const Json& list)
{
  std::string text;
  for (const auto& element : list)
    text += (text.empty() ? "\n    " : ",\n    ") + element.dump();
  return "[" + text + "\n  ]";
}

} // namespace

std::string
describeScene(const Building& building, const std::vector<Eigen::Vector3d>& trajectory)
{
  Json rooms = Json::array(), objects = Json::array(), positions = Json::array();
  for (std::size_t i = 0; i < building.rooms.size(); ++i)
    rooms.push_back(describeRoom(building, i));
  for (std::size_t i = 0; i < building.objects.size(); ++i)
    objects.push_back(describeObject(building.objects[i], i + 1));
  for (const auto& position : trajectory)
    positions.push_back(listOf(position));
  return "{\n  \"categories\": " + Json(building.categories).dump() +
         ",\n  \"rooms\": " + linesOf(rooms) + ",\n  \"objects\": " + linesOf(objects) +
         ",\n  \"trajectory\": " + linesOf(positions) + "\n}\n";
}

} // namespace pcl::indoor
