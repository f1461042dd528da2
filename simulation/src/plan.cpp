/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "json_reader.h"

#include <pcl/simulation/furniture.h>
#include <pcl/simulation/polygon.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

namespace pcl {
namespace indoor {

namespace {

constexpr double radians_per_degree = M_PI / 180;

CeilingPlan
readCeiling(const JsonReader& json)
{
  CeilingPlan ceiling;
  if (!json.isObject()) {
    ceiling.height = json.positive();
    return ceiling;
  }
  json.requireKeys({"height", "at", "slope"});
  ceiling.height = json.at("height").positive();
  ceiling.at = json.at("at").vector<2>();
  ceiling.slope = json.at("slope").vector<2>();
  return ceiling;
}

RoomPlan
readRoom(const JsonReader& json, double ceiling_height)
{
  constexpr double lowest = 1.8; // metres: nobody stands below
  json.requireKeys({"name", "polygon", "ceiling"});
  RoomPlan room;
  room.name = json.at("name").text();
  room.ceiling.height = ceiling_height;
  if (json.has("ceiling"))
    room.ceiling = readCeiling(json.at("ceiling"));
  const auto polygon = json.at("polygon");
  for (const auto& vertex : polygon.values())
    room.polygon.push_back(vertex.vector<2>());
  if (room.polygon.size() < 3)
    polygon.fail("needs at least 3 vertices");
  if (crossesItself(room.polygon))
    polygon.fail("crosses or touches itself");
  if (signedArea(room.polygon) < 0)
    std::reverse(room.polygon.begin(), room.polygon.end());
  for (const auto& vertex : room.polygon)
    if (!(room.ceiling.heightAt(vertex) >= lowest)) {
      std::ostringstream problem;
      problem << "leaves only " << room.ceiling.heightAt(vertex) << " m at ("
              << vertex.x() << ", " << vertex.y() << "); it needs " << lowest << " m";
      (json.has("ceiling") ? json.at("ceiling") : json).fail(problem.str());
    }
  return room;
}

OpeningPlan
readOpening(const JsonReader& json, OpeningKind kind)
{
  OpeningPlan opening;
  opening.kind = kind;
  if (kind == OpeningKind::Door)
    json.requireKeys({"at", "width", "height", "angle", "into", "hinge"});
  else
    json.requireKeys({"at", "width", "height", "sill"});
  opening.at = json.at("at").vector<2>();
  opening.width = json.at("width").positive();
  if (kind == OpeningKind::Window) {
    opening.height = json.at("height").positive();
    opening.sill = json.at("sill").number();
  }
  else {
    if (json.has("height"))
      opening.height = json.at("height").positive();
    if (json.has("sill"))
      opening.sill = json.at("sill").number();
  }
  if (opening.sill < 0)
    json.at("sill").fail("must not be negative");
  if (kind != OpeningKind::Passage && (opening.width < 0.3 || opening.height < 0.3))
    json.fail("must be at least 0.3 m wide and high");
  if (json.has("angle")) {
    const double degrees = json.at("angle").number();
    if (!(degrees >= 0 && degrees <= 170))
      json.at("angle").fail("must lie within 0 and 170 degrees");
    opening.leaf_angle = degrees * radians_per_degree;
  }
  if (json.has("into"))
    opening.into = json.at("into").text();
  if (json.has("hinge")) {
    const auto hinge = json.at("hinge").text();
    if (hinge != "left" && hinge != "right")
      json.at("hinge").fail("must be 'left' or 'right', not '" + hinge + "'");
    opening.hinge_left = hinge == "left";
  }
  return opening;
}

FurniturePlan
readFurniture(const JsonReader& json)
{
  json.requireKeys({"class", "at", "rotation", "elevation", "size", "seed"});
  FurniturePlan item;
  item.category = json.at("class").text();
  const auto known = furnitureCategories();
  if (!std::binary_search(known.begin(), known.end(), item.category)) {
    std::string list;
    for (const auto& name : known)
      list += (list.empty() ? "" : ", ") + name;
    json.at("class").fail("'" + item.category + "' is none of: " + list);
  }
  item.at = json.at("at").vector<2>();
  if (json.has("rotation"))
    item.rotation = json.at("rotation").number() * radians_per_degree;
  if (json.has("elevation"))
    item.elevation = json.at("elevation").number();
  if (json.has("size")) {
    item.size = json.at("size").vector<3>();
    if (!(item.size->minCoeff() >= 0.02))
      json.at("size").fail("must be at least 0.02 m in every direction");
  }
  if (json.has("seed"))
    item.seed = json.at("seed").seed();
  return item;
}

StoreyPlan
readStorey(const JsonReader& json)
{
  json.requireKeys({"name",
                    "elevation",
                    "ceiling_height",
                    "rooms",
                    "doors",
                    "windows",
                    "passages",
                    "furniture"});
  StoreyPlan storey;
  storey.name = json.at("name").text();
  storey.elevation = json.at("elevation").number();
  const double height = json.at("ceiling_height").positive();
  for (const auto& room : json.at("rooms").values())
    storey.rooms.push_back(readRoom(room, height));
  if (storey.rooms.empty())
    json.at("rooms").fail("must hold at least one room");
  for (const auto& door : json.list("doors"))
    storey.openings.push_back(readOpening(door, OpeningKind::Door));
  for (const auto& window : json.list("windows"))
    storey.openings.push_back(readOpening(window, OpeningKind::Window));
  for (const auto& passage : json.list("passages"))
    storey.openings.push_back(readOpening(passage, OpeningKind::Passage));
  for (const auto& item : json.list("furniture"))
    storey.furniture.push_back(readFurniture(item));
  return storey;
}

void
requireDistinctNames(const Plan& plan, const std::string& source)
{
  std::set<std::string> names;
  for (const auto& storey : plan.storeys)
    for (const auto& room : storey.rooms)
      if (!names.insert(room.name).second)
        throw PlanError(source + ": rooms: the name '" + room.name +
                        "' is given to two rooms");
}

} // namespace

Plan
parsePlan(const std::string& text, const std::string& source)
{
  nlohmann::json document;
  try {
    document = nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const auto end = static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    const auto line = 1 + std::count(text.begin(), text.begin() + end, '\n');
    throw PlanError(source + ": line " + std::to_string(line) + " is not valid JSON");
  }
  const JsonReader json(document, source);
  json.requireKeys({"name", "wall_thickness", "seed", "storeys", "trajectory"});
  Plan plan;
  plan.name = json.at("name").text();
  plan.wall_thickness = json.at("wall_thickness").positive();
  if (plan.wall_thickness > 1.0)
    json.at("wall_thickness").fail("must be at most 1 m");
  if (json.has("seed"))
    plan.seed = json.at("seed").seed();
  for (const auto& storey : json.at("storeys").values())
    plan.storeys.push_back(readStorey(storey));
  if (plan.storeys.empty())
    json.at("storeys").fail("must hold at least one storey");
  for (const auto& position : json.list("trajectory"))
    plan.trajectory.push_back(position.vector<3>());
  requireDistinctNames(plan, source);
  return plan;
}

Plan
readPlan(const std::string& file_name)
{
  std::ifstream file(file_name);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf()))
    throw PlanError(file_name + ": cannot be read");
  return parsePlan(text.str(), file_name);
}

} // namespace indoor
} // namespace pcl
