/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "building/ceiling_facets.h"
#include "plan/shape_reader.h"

#include <pcl/simulation/furniture.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

namespace pcl::indoor {

namespace {

RoomPlan
readRoom(const JsonReader& json, const std::vector<CeilingPlane>& storey_ceiling)
{
  constexpr double lowest = 1.8; // metres: nobody stands below
  json.requireKeys({"name", "kind", "polygon", "ceiling", "ceiling_parts"});
  RoomPlan room;
  room.name = json.at("name").text();
  if (json.has("kind"))
    room.kind = json.at("kind").text();
  room.polygon = readPolygon(json.at("polygon"));
  room.ceiling.planes =
      json.has("ceiling") ? readCeiling(json.at("ceiling")) : storey_ceiling;
  for (const auto& part : json.list("ceiling_parts")) {
    part.requireKeys({"polygon", "ceiling"});
    room.ceiling.parts.push_back(
        {readConvexPolygon(part.at("polygon")), readCeiling(part.at("ceiling"))});
    for (std::size_t i = 0; i + 1 < room.ceiling.parts.size(); ++i)
      if (overlap(room.ceiling.parts[i].polygon, room.ceiling.parts.back().polygon))
        part.fail("overlaps another part of the ceiling");
  }
  const double highest = ceilingRange(room.ceiling, room.polygon).second;
  if (!(highest >= lowest)) {
    std::ostringstream problem;
    problem << "leaves at most " << highest << " m; a room needs " << lowest
            << " m somewhere";
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
  else if (kind == OpeningKind::Window)
    json.requireKeys({"at", "width", "height", "sill", "frame_width", "frame_depth"});
  else
    json.requireKeys({"at", "width", "height", "sill"});
  opening.at = json.at("at").vector<2>();
  opening.width = json.at("width").positive();
  const bool must_have_both = kind == OpeningKind::Window;
  if (must_have_both || json.has("height"))
    opening.height = json.at("height").positive();
  if (must_have_both || json.has("sill"))
    opening.sill = json.at("sill").number();
  if (json.has("frame_width"))
    opening.frame_width = json.at("frame_width").positive();
  if (json.has("frame_depth"))
    opening.frame_depth = json.at("frame_depth").positive();
  if (opening.sill < 0)
    json.at("sill").fail("must not be negative");
  if (kind != OpeningKind::Passage && (opening.width < 0.3 || opening.height < 0.3))
    json.fail("must be at least 0.3 m wide and high");
  if (3 * opening.frame_width > std::min(opening.width, opening.height))
    json.fail("must be at least three times as wide and high as its frame");
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
  json.requireKeys({"class",
                    "at",
                    "rotation",
                    "elevation",
                    "size",
                    "seed",
                    "variant",
                    "room",
                    "turn",
                    "lies"});
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
  if (json.has("variant")) {
    const double variant = json.at("variant").number();
    const int variants = furnitureVariants(item.category);
    if (variant != std::floor(variant) || variant < 0 || variant >= variants)
      json.at("variant").fail("must be a whole number from 0 to " +
                              std::to_string(variants - 1) + " for a " + item.category);
    item.variant = static_cast<int>(variant);
  }
  if (json.has("lies")) {
    const std::set<std::string> cloths{"blanket", "clothes", "towel"};
    if (json.at("lies").text() != "over" || cloths.count(item.category) == 0)
      json.at("lies").fail("must be 'over', and only blanket, clothes, towel have it");
    if (!item.size)
      json.at("lies").fail("needs a size");
    item.draped = true;
  }
  if (json.has("room"))
    item.room = json.at("room").text();
  if (json.has("turn")) {
    if (item.category != "stairs" || json.at("turn").text() != "half")
      json.at("turn").fail("must be 'half', and only stairs have it");
    if (!item.size || item.size->x() < 1.2 || item.size->y() < item.size->x() ||
        item.size->z() < 1.7)
      json.at("turn").fail("needs a size of at least [1.2, width, 1.7]");
    item.half_turn = true;
  }
  return item;
}

PlatformPlan
readPlatform(const JsonReader& json)
{
  json.requireKeys({"polygon", "height", "thickness", "room"});
  PlatformPlan platform;
  platform.polygon = readPolygon(json.at("polygon"));
  platform.top = readPlane(json.at("height"));
  if (json.has("thickness"))
    platform.thickness = json.at("thickness").positive();
  if (json.has("room"))
    platform.room = json.at("room").text();
  return platform;
}

WellPlan
readWell(const JsonReader& json)
{
  json.requireKeys({"polygon"});
  return {readConvexPolygon(json.at("polygon"))};
}

double
readLeanAngle(const JsonReader& json, double lowest)
{
  constexpr double most = 45.0; // degrees: beyond, walls are rather roofs
  const double angle = json.number();
  if (!(angle >= lowest && angle <= most)) {
    std::ostringstream problem;
    problem << "must lie within " << lowest << " and " << most << " degrees";
    json.fail(problem.str());
  }
  return angle * radians_per_degree;
}

LeaningWallPlan
readLeaningWall(const JsonReader& json)
{
  json.requireKeys({"from", "to", "angle"});
  LeaningWallPlan wall;
  wall.from = json.at("from").vector<2>();
  wall.to = json.at("to").vector<2>();
  wall.angle = readLeanAngle(json.at("angle"), -45.0);
  if ((wall.to - wall.from).norm() < 0.1)
    json.fail("must be at least 0.1 m long");
  return wall;
}

LeanPlan
readLean(const JsonReader& json)
{
  json.requireKeys({"angle", "towards"});
  return {readLeanAngle(json.at("angle"), 0.0),
          json.at("towards").number() * radians_per_degree};
}

StoreyPlan
readStorey(const JsonReader& json)
{
  json.requireKeys({"name",
                    "elevation",
                    "ceiling_height",
                    "ceiling",
                    "rooms",
                    "doors",
                    "windows",
                    "passages",
                    "platforms",
                    "wells",
                    "furniture"});
  StoreyPlan storey;
  storey.name = json.at("name").text();
  storey.elevation = json.at("elevation").number();
  if (json.has("ceiling") && json.has("ceiling_height"))
    json.fail("gives both ceiling and ceiling_height");
  std::vector<CeilingPlane> ceiling(1);
  if (json.has("ceiling"))
    ceiling = readCeiling(json.at("ceiling"));
  else
    ceiling[0].height = json.at("ceiling_height").positive();
  for (const auto& room : json.at("rooms").values())
    storey.rooms.push_back(readRoom(room, ceiling));
  if (storey.rooms.empty())
    json.at("rooms").fail("must hold at least one room");
  for (const auto& door : json.list("doors"))
    storey.openings.push_back(readOpening(door, OpeningKind::Door));
  for (const auto& window : json.list("windows"))
    storey.openings.push_back(readOpening(window, OpeningKind::Window));
  for (const auto& passage : json.list("passages"))
    storey.openings.push_back(readOpening(passage, OpeningKind::Passage));
  for (const auto& platform : json.list("platforms"))
    storey.platforms.push_back(readPlatform(platform));
  for (const auto& well : json.list("wells"))
    storey.wells.push_back(readWell(well));
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
  } catch (const nlohmann::json::out_of_range&) {
    throw PlanError(source + ": a number is too large");
  }
  const JsonReader json(document, source);
  json.requireKeys({"name",
                    "wall_thickness",
                    "seed",
                    "lean",
                    "leaning_walls",
                    "storeys",
                    "trajectory"});
  Plan plan;
  plan.name = json.at("name").text();
  plan.wall_thickness = json.at("wall_thickness").positive();
  if (plan.wall_thickness > 1.0)
    json.at("wall_thickness").fail("must be at most 1 m");
  if (json.has("seed"))
    plan.seed = json.at("seed").seed();
  if (json.has("lean"))
    plan.lean = readLean(json.at("lean"));
  for (const auto& wall : json.list("leaning_walls"))
    plan.leaning_walls.push_back(readLeaningWall(wall));
  for (const auto& storey : json.at("storeys").values())
    plan.storeys.push_back(readStorey(storey));
  if (plan.storeys.empty())
    json.at("storeys").fail("must hold at least one storey");
  for (const auto& position : json.list("trajectory"))
    plan.trajectory.push_back(position.vector<3>());
  requireDistinctNames(plan, source);
  return plan;
}

void
setLean(Plan& plan, double angle)
{
  if (!plan.lean && plan.leaning_walls.empty())
    throw PlanError("the plan '" + plan.name +
                    "' says neither that it leans nor which walls do");
  if (plan.lean)
    plan.lean->angle = angle;
  for (auto& wall : plan.leaning_walls)
    wall.angle = std::copysign(angle, wall.angle);
}

void
setLean(Plan& plan, const LeanPlan& lean)
{
  plan.lean = lean;
  plan.leaning_walls.clear();
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

} // namespace pcl::indoor
