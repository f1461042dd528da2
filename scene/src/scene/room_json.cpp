/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/room_json.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace pcl::indoor::tool {
namespace {

using Json = nlohmann::ordered_json;

Json
footprintJson(const Room& room, const Eigen::Vector3d& offset)
{
  Json lines = Json::array();
  for (const auto& line : room.footprint) {
    Json corners = Json::array();
    for (const auto& corner : line)
      corners.push_back(positionJson(corner + offset));
    lines.push_back(std::move(corners));
  }
  return lines;
}

Json
neighboursJson(const Room& room,
               const std::vector<RoomOpening>& openings,
               const Eigen::Vector3d& offset)
{
  Json neighbours = Json::array();
  for (const auto& opening : openings) {
    if (opening.room_a != room.label && opening.room_b != room.label)
      continue;
    Json json;
    json["room"] = opening.room_a == room.label ? opening.room_b : opening.room_a;
    json["position"] = positionJson(opening.position + offset);
    json["width"] = rounded(opening.width);
    json["area"] = rounded(opening.area);
    neighbours.push_back(std::move(json));
  }
  return neighbours;
}

/** The names of several stations, and the positions of those that are known. */
void
addStations(const std::vector<Station>& stations, Json& json)
{
  Json names = Json::array(), positions = Json::array();
  for (const auto& station : stations) {
    const auto& at = station.position;
    names.push_back(station.name);
    positions.push_back(at ? Json{at->x(), at->y(), at->z()} : Json());
  }
  if (stations.size() > 1)
    json["stations"] = names;
  const auto is_known = [](const auto& station) {
    return station.position.has_value();
  };
  if (std::any_of(stations.begin(), stations.end(), is_known))
    json["station_positions"] = positions;
}

} // namespace

Json
positionJson(const Eigen::Vector3d& position)
{
  return {rounded(position.x()), rounded(position.y()), rounded(position.z())};
}

Json
roomsJson(const std::vector<Room>& rooms,
          const std::vector<RoomOpening>& openings,
          const Eigen::Vector3d& offset)
{
  Json list = Json::array();
  for (const auto& room : rooms) {
    Json json;
    json["room"] = room.label;
    json["storey"] = room.storey;
    if (room.point_count > 0)
      addPlaceJson(json, room, offset);
    else
      json["points"] = 0;
    json["area"] = rounded(room.area);
    json["height"] = rounded(room.height);
    json["seen"] = rounded(room.seen);
    json["floor_seen"] = rounded(room.floor_seen);
    json["ceiling_seen"] = rounded(room.ceiling_seen);
    json["volume"] = rounded(room.volume);
    json["footprint"] = footprintJson(room, offset);
    json["neighbours"] = neighboursJson(room, openings, offset);
    list.push_back(std::move(json));
  }
  return list;
}

SceneInput
inputOf(const CloudFile& file)
{
  return {file.path, file.stations, file.pose.offset};
}

Json
inputJson(const SceneInput& input)
{
  const auto& offset = input.cloud_offset;
  Json json;
  json["input"] = std::filesystem::path(input.path).filename().string();
  addStations(input.stations, json);
  json["unit"] = "metre";
  json["offset"] = {offset.x(), offset.y(), offset.z()};
  return json;
}

} // namespace pcl::indoor::tool
