/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/saved_scene.h"

#include "files/tool_error.h"
#include "pictures/floor_plan.h" // for widest_door
#include "scene/coordinate_options.h"
#include "scene/model_json.h"  // for nameOf
#include "scene/scene_query.h" // for readScene
#include "text/printable.h"

#include <pcl/model/room_names.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr double farthest = 1e9; // metres from the origin, of any place

double
numberOf(const Json& json, double least = -farthest)
{
  const double value = json.get<double>();
  if (!(value >= least && value <= farthest))
    throw ToolError("the number " + json.dump() + " is out of range");
  return value;
}

Eigen::Vector3d
vectorOf(const Json& json)
{
  return {numberOf(json.at(0)), numberOf(json.at(1)), numberOf(json.at(2))};
}

std::uint32_t
indexOf(const Json& json, const char* what, std::size_t count)
{
  const auto value = json.get<std::int64_t>();
  if (value < 0 || static_cast<std::uint64_t>(value) >= count)
    throw ToolError("there is no " + std::string(what) + " " + json.dump());
  return static_cast<std::uint32_t>(value);
}

/** From the frame and unit of the file to that of SavedScene. */
class LevelFrame {
public:
  explicit LevelFrame(const Json& scene)
  {
    frame_.metres_per_unit =
        metresOfUnit(scene.at("coordinate_unit").get<std::string>());
    const auto& axes = scene.at("axes");
    up_ = vectorOf(axes.at("up")).normalized();
    x_ = vectorOf(axes.at("x"));
    y_ = vectorOf(axes.at("y"));
    if (!(std::abs(up_.norm() - 1.0) < 1e-6) || !(x_.cross(y_).norm() > 0.9))
      throw ToolError("axes are no three directions");
    turn_ = Eigen::Quaterniond::FromTwoVectors(up_, Eigen::Vector3d::UnitZ());
    frame_.pose.linear() = turn_.conjugate().toRotationMatrix();
    frame_.offset = vectorOf(scene.at("offset"));
  }

  Eigen::Vector3d
  place(const Json& json) const
  {
    return turn_ * (frame_.metres_per_unit * (vectorOf(json) - frame_.offset));
  }

  /** Of a height along the up axis, metres. */
  double
  height(const Json& json) const
  {
    return numberOf(json) - frame_.metres_per_unit * up_.dot(frame_.offset);
  }

  double
  yaw(double radians) const
  {
    const Eigen::Vector3d way =
        turn_ * (std::cos(radians) * x_ + std::sin(radians) * y_);
    return std::atan2(way.y(), way.x());
  }

  /** The offset of a scan that leans a little is not turned: it may be far away. */
  Eigen::Vector3d
  origin() const
  {
    constexpr double level = 0.9962; // cosine of 5 degrees
    const Eigen::Vector3d& offset = frame_.offset;
    return frame_.metres_per_unit * (up_.z() > level ? offset : turn_ * offset);
  }

  const BuildingFrame&
  frame() const
  {
    return frame_;
  }

private:
  BuildingFrame frame_;
  Eigen::Vector3d up_, x_, y_;
  Eigen::Quaterniond turn_;
};

/** A name that rooms can have: it is written into drawings and models as it is. */
std::string
requiredName(const std::string& name)
{
  for (std::size_t n = 0; n < room_name_count; ++n)
    if (name == nameOf(static_cast<RoomName>(n)))
      return name;
  throw ToolError("'" + printable(name) + "' is no name of a room");
}

SavedRoom
roomOf(const Json& json, const LevelFrame& frame, const SavedScene& scene)
{
  SavedRoom room;
  room.number = json.at("room").get<std::uint32_t>();
  if (room.number != scene.rooms.size() + 1)
    throw ToolError("the rooms are not numbered from 1");
  room.storey = indexOf(json.at("storey"), "storey", scene.storeys.size());
  room.area = numberOf(json.at("area"), 0.0);
  room.height = numberOf(json.at("height"), 0.0);
  room.volume = numberOf(json.at("volume"), 0.0);
  room.floor = scene.storeys[room.storey].floor;
  if (const auto name = json.value("name", "unknown"); name != "unknown") {
    room.name = requiredName(name);
    room.name_probability = numberOf(json.at("name_probability"), 0.0);
  }
  bool is_first = true;
  for (const auto& line : json.at("footprint")) {
    PlanRing ring;
    for (const auto& corner : line) {
      const auto place = frame.place(corner);
      if (is_first)
        room.floor = place.z();
      is_first = false;
      ring.emplace_back(place.head<2>());
    }
    if (ring.size() >= 3)
      room.rings.push_back(std::move(ring));
  }
  return room;
}

SavedWall
wallOf(const Json& json, const LevelFrame& frame, const SavedScene& scene)
{
  SavedWall wall;
  wall.number = json.at("wall").get<std::uint32_t>();
  if (wall.number != scene.walls.size() + 1)
    throw ToolError("the walls are not numbered from 1");
  wall.storey = indexOf(json.at("storey"), "storey", scene.storeys.size());
  const auto begin = frame.place(json.at("begin")), end = frame.place(json.at("end"));
  wall.begin = begin.head<2>();
  wall.end = end.head<2>();
  wall.floor = begin.z();
  wall.height = numberOf(json.at("height"), 0.0);
  if (json.contains("thickness"))
    wall.thickness = numberOf(json["thickness"], 0.0);
  return wall;
}

SavedColumn
columnOf(const Json& json, const LevelFrame& frame, const SavedScene& scene)
{
  SavedColumn column;
  column.number = static_cast<std::uint32_t>(scene.columns.size() + 1);
  column.storey = indexOf(json.at("storey"), "storey", scene.storeys.size());
  column.foot = frame.place(json.at("position"));
  column.size = vectorOf(json.at("size"));
  column.yaw = frame.yaw(numberOf(json.at("yaw_degrees")) * M_PI / 180.0);
  column.is_round = json.at("round").get<bool>();
  if (!(column.size.minCoeff() >= 0.0))
    throw ToolError("column " + std::to_string(column.number) +
                    " has a side of less than 0 m");
  return column;
}

ModelOpeningKind
kindOf(const std::string& name)
{
  for (const auto kind :
       {ModelOpeningKind::Door, ModelOpeningKind::Window, ModelOpeningKind::Passage})
    if (name == nameOf(kind))
      return kind;
  throw ToolError("'" + printable(name) + "' is no kind of an opening");
}

/** What version 1 does not tell: kind and height. */
void
addGuesses(SavedOpening& opening, double area)
{
  opening.kind =
      opening.width <= widest_door ? ModelOpeningKind::Door : ModelOpeningKind::Passage;
  opening.height = opening.width > 0.0 ? area / opening.width : 0.0;
}

SavedOpening
openingOf(const Json& json, const LevelFrame& frame, const SavedScene& scene)
{
  SavedOpening opening;
  opening.number = static_cast<std::uint32_t>(scene.openings.size() + 1);
  const auto& rooms = json.at("rooms");
  opening.room_a = indexOf(rooms.at(0), "room", scene.rooms.size() + 1);
  opening.room_b = indexOf(rooms.at(1), "room", scene.rooms.size() + 1);
  opening.storey = indexOf(json.at("storey"), "storey", scene.storeys.size());
  opening.position = frame.place(json.at("position"));
  opening.width = numberOf(json.at("width"), 0.0);
  opening.wall = scene.walls.size();
  if (!json.contains("kind")) {
    addGuesses(opening, numberOf(json.at("area"), 0.0));
    return opening;
  }
  opening.kind = kindOf(json["kind"].get<std::string>());
  opening.height = numberOf(json.at("height"), 0.0);
  opening.sill = numberOf(json.at("sill"), 0.0);
  opening.is_open = json.at("open").get<bool>();
  if (json.contains("wall")) {
    const auto number = indexOf(json["wall"], "wall", scene.walls.size() + 1);
    if (number == 0)
      throw ToolError("there is no wall 0");
    opening.wall = number - 1;
  }
  return opening;
}

SavedObject
objectOf(const Json& json, const LevelFrame& frame, const SavedScene& scene)
{
  SavedObject object;
  object.number = json.at("object").get<std::uint32_t>();
  object.room = indexOf(json.at("room"), "room", scene.rooms.size() + 1);
  object.is_structure = json.at("structure") != "none";
  if (!object.is_structure)
    object.name = json.value("class", "");
  object.confidence = json.contains("confidence") ? numberOf(json["confidence"]) : 0.0;
  const auto& box = json.at("upright_box");
  object.box.center = frame.place(box.at("center"));
  object.box.size = vectorOf(box.at("size"));
  object.box.yaw = frame.yaw(numberOf(box.at("yaw_degrees")) * M_PI / 180.0);
  if (!(object.box.size.minCoeff() >= 0.0))
    throw ToolError("object " + std::to_string(object.number) +
                    " has a side of less than 0 m");
  const double foot = object.box.center.z() - 0.5 * object.box.size.z();
  object.storey = object.room > 0 ? scene.rooms[object.room - 1].storey
                                  : storeyAt(foot, scene.storeys);
  return object;
}

} // namespace

std::uint32_t
storeyAt(double height, const std::vector<SavedStorey>& storeys)
{
  constexpr double step = 0.3; // metres that an object may reach into the floor
  std::uint32_t storey = 0;
  for (std::size_t s = 0; s < storeys.size(); ++s)
    if (storeys[s].floor <= height + step)
      storey = static_cast<std::uint32_t>(s);
  return storey;
}

PlanRing
outlineOf(const SavedColumn& column)
{
  constexpr int round_sides = 24;
  PlanRing ring;
  if (column.is_round)
    for (int k = 0; k < round_sides; ++k)
      ring.emplace_back(Eigen::Rotation2Dd(2.0 * M_PI * k / round_sides) *
                        Eigen::Vector2d(0.5, 0.0));
  else
    ring = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  const Eigen::Rotation2Dd turn(column.yaw);
  for (auto& corner : ring)
    corner = column.foot.head<2>() + turn * corner.cwiseProduct(column.size.head<2>());
  return ring;
}

SavedScene
savedScene(const Json& json)
{
  SavedScene scene;
  const LevelFrame frame(json);
  scene.version = json.at("version").get<int>();
  scene.input = json.value("input", "");
  scene.origin = frame.origin();
  scene.frame = frame.frame();
  for (const auto& storey : json.at("storeys"))
    scene.storeys.push_back(
        {frame.height(storey.at("floor")), frame.height(storey.at("ceiling"))});
  for (const auto& room : json.at("rooms"))
    scene.rooms.push_back(roomOf(room, frame, scene));
  if (scene.version > 1)
    for (const auto& wall : json.at("walls"))
      scene.walls.push_back(wallOf(wall, frame, scene));
  if (json.contains("columns"))
    for (const auto& column : json["columns"])
      scene.columns.push_back(columnOf(column, frame, scene));
  for (const auto& opening : json.at("openings"))
    scene.openings.push_back(openingOf(opening, frame, scene));
  for (const auto& object : json.at("objects"))
    if (!scene.storeys.empty())
      scene.objects.push_back(objectOf(object, frame, scene));
  return scene;
}

SavedScene
readSavedScene(const std::string& path)
{
  const auto json = readScene(path);
  try {
    return savedScene(json);
  } catch (const Json::exception& problem) {
    throw ToolError(path + ": not a whole scene, " + messageOf(problem));
  } catch (const ToolError& problem) {
    throw ToolError(path + ": " + problem.what());
  }
}

} // namespace pcl::indoor::tool
