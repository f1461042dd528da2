/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/model_json.h"

#include "scene/room_json.h"

#include <cmath>

namespace pcl::indoor::tool {
namespace {

using Json = nlohmann::ordered_json;

} // namespace

const char*
nameOf(ModelOpeningKind kind)
{
  constexpr const char* names[] = {"door", "window", "passage"};
  return names[static_cast<int>(kind)];
}

Json
openingsJson(const BuildingModel& model, const Eigen::Affine3d& to_file)
{
  Json openings = Json::array();
  for (const auto& opening : model.openings) {
    Json json = {{"opening", openings.size() + 1},
                 {"kind", nameOf(opening.kind)},
                 {"rooms", {opening.room_a, opening.room_b}},
                 {"storey", opening.storey},
                 {"position", positionJson(to_file * opening.position)},
                 {"width", rounded(opening.width)},
                 {"height", rounded(opening.height)},
                 {"sill", rounded(opening.sill)},
                 {"head", rounded(opening.head())},
                 {"area", rounded(opening.width * opening.height)},
                 {"open", opening.is_open}};
    if (opening.wall < model.walls.size())
      json["wall"] = opening.wall + 1;
    openings.push_back(std::move(json));
  }
  return openings;
}

Json
wallsJson(const BuildingModel& model, const Eigen::Affine3d& to_file)
{
  Json walls = Json::array();
  for (const auto& wall : model.walls) {
    const auto end = [&](const Eigen::Vector2d& place) {
      return positionJson(to_file * Eigen::Vector3d(place.x(), place.y(), wall.floor));
    };
    Json json = {{"wall", walls.size() + 1},
                 {"storey", wall.storey},
                 {"rooms", wall.rooms},
                 {"begin", end(wall.begin)},
                 {"end", end(wall.end)},
                 {"height", rounded(wall.height)}};
    if (wall.thickness > 0.0)
      json["thickness"] = rounded(wall.thickness);
    walls.push_back(std::move(json));
  }
  return walls;
}

Json
columnsJson(const BuildingModel& model, const Eigen::Affine3d& to_file)
{
  Json columns = Json::array();
  for (const auto& column : model.columns) {
    const Eigen::Vector3d foot(column.center.x(), column.center.y(), column.floor);
    const Eigen::Vector3d size(column.size.x(), column.size.y(), column.height);
    columns.push_back({{"column", columns.size() + 1},
                       {"storey", column.storey},
                       {"room", column.room},
                       {"position", positionJson(to_file * foot)},
                       {"size", positionJson(size)},
                       {"yaw_degrees", rounded(column.yaw * 180.0 / M_PI)},
                       {"round", column.is_round}});
  }
  return columns;
}

} // namespace pcl::indoor::tool
