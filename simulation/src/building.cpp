/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "room_shell.h"

#include <pcl/simulation/building.h>
#include <pcl/simulation/furniture.h>
#include <pcl/simulation/random_draw.h> // for mixSeed

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace pcl {
namespace indoor {

namespace {

std::vector<std::string>
categoryNames()
{
  std::vector<std::string> names{
      "none", "floor", "ceiling", "wall", "door", "window", "ghost"};
  for (const auto& name : furnitureCategories())
    names.push_back(name);
  return names;
}

// Walls thicker than the room turn its edges around.
bool
vanishes(const Polygon& outline, const Polygon& inner)
{
  constexpr double smallest = 0.25; // square metres
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t next = (i + 1) % outline.size();
    if ((outline[next] - outline[i]).dot(inner[next] - inner[i]) <= 0)
      return true;
  }
  return crossesItself(inner) || signedArea(inner) < smallest;
}

std::vector<RoomInfo>
makeRooms(const Plan& plan, const std::string& source)
{
  std::vector<RoomInfo> rooms;
  for (std::size_t s = 0; s < plan.storeys.size(); ++s)
    for (const auto& room : plan.storeys[s].rooms) {
      RoomInfo info;
      info.name = room.name;
      info.storey_name = plan.storeys[s].name;
      info.storey = static_cast<std::uint32_t>(s);
      info.polygon = inset(room.polygon, plan.wall_thickness / 2);
      info.floor = plan.storeys[s].elevation;
      info.ceiling = room.ceiling;
      if (vanishes(room.polygon, info.polygon))
        throw PlanError(source + ": rooms: room '" + room.name +
                        "' vanishes between its walls (wall_thickness)");
      rooms.push_back(info);
    }
  return rooms;
}

double
highestCeiling(const RoomInfo& room)
{
  double highest = 0;
  for (const auto& p : room.polygon)
    highest = std::max(highest, room.ceiling.heightAt(p));
  return room.floor + highest;
}

void
requireApart(const std::vector<RoomInfo>& rooms, const std::string& source)
{
  for (std::size_t i = 0; i < rooms.size(); ++i)
    for (std::size_t j = i + 1; j < rooms.size(); ++j)
      if (rooms[i].floor < highestCeiling(rooms[j]) &&
          rooms[j].floor < highestCeiling(rooms[i]) &&
          overlap(rooms[i].polygon, rooms[j].polygon))
        throw PlanError(source + ": rooms: '" + rooms[i].name + "' and '" +
                        rooms[j].name + "' overlap");
}

// Where furniture stands: in its room, with its size known and its height settled.
struct Placement {
  std::uint32_t room = 0; // number, from 1
  double elevation = 0;   // of its lowest point, metres
  FurnitureModel model;
  std::array<Eigen::Vector2d, 4> corners;
};

std::array<Eigen::Vector2d, 4>
footprint(const FurniturePlan& item, const Eigen::Vector3d& size)
{
  const Eigen::Rotation2Dd turn(item.rotation);
  const double x = size.x() / 2, y = size.y() / 2;
  return {item.at + turn * Eigen::Vector2d(-x, -y),
          item.at + turn * Eigen::Vector2d(x, -y),
          item.at + turn * Eigen::Vector2d(x, y),
          item.at + turn * Eigen::Vector2d(-x, y)};
}

[[noreturn]] void
failFurniture(const std::string& source,
              const StoreyPlan& storey,
              const FurniturePlan& item,
              const std::string& problem)
{
  std::ostringstream message;
  message << source << ": furniture of storey '" << storey.name << "': the "
          << item.category << " at (" << item.at.x() << ", " << item.at.y() << ") "
          << problem;
  throw PlanError(message.str());
}

std::uint32_t
roomOf(const std::vector<RoomInfo>& rooms,
       std::size_t storey,
       const Eigen::Vector2d& at)
{
  for (std::size_t r = 0; r < rooms.size(); ++r)
    if (rooms[r].storey == storey && contains(rooms[r].polygon, at))
      return static_cast<std::uint32_t>(r + 1);
  return 0;
}

Placement
place(const FurniturePlan& item,
      std::uint32_t seed,
      const std::vector<RoomInfo>& rooms,
      std::size_t storey_number,
      const StoreyPlan& storey,
      const std::string& source)
{
  constexpr double into_wall = 0.05; // metres that furniture may reach into a wall
  Placement result;
  result.room = roomOf(rooms, storey_number, item.at);
  if (result.room == 0)
    failFurniture(source, storey, item, "stands in no room");
  const auto& room = rooms[result.room - 1];
  result.model = makeFurniture(item.category, seed, item.size);
  result.corners = footprint(item, result.model.size);
  double lowest = room.ceiling.heightAt(item.at), highest = lowest;
  for (const auto& corner : result.corners) {
    if (!contains(room.polygon, corner) &&
        distanceToBoundary(room.polygon, corner) > into_wall)
      failFurniture(
          source, storey, item, "reaches through a wall of room '" + room.name + "'");
    lowest = std::min(lowest, room.ceiling.heightAt(corner));
    highest = std::max(highest, room.ceiling.heightAt(corner));
  }
  if (item.category == "column" && !item.size) {
    Eigen::Vector3d size = result.model.size;
    size.z() = highest;
    result.model = makeFurniture(item.category, seed, size);
  }
  const bool hangs = item.category == "beam" || item.category == "ceiling_lamp";
  const double height = result.model.size.z();
  const double above = item.elevation.value_or(hangs ? lowest - height : 0.0);
  result.elevation = room.floor + above;
  if (above < 0)
    failFurniture(source, storey, item, "stands below the floor (elevation)");
  if (above + height > highest + 0.02)
    failFurniture(source, storey, item, "is higher than its room");
  return result;
}

// Puts triangles with their labels into a building.
class Assembler {
public:
  explicit Assembler(Building& building)
  : building_(building)
  {}

  void
  addShell(const std::vector<ShellPiece>& pieces, std::uint32_t room)
  {
    const std::uint32_t categories[3] = {building_.category("floor"),
                                         building_.category("wall"),
                                         building_.category("ceiling")};
    for (const auto& piece : pieces) {
      Surface surface;
      surface.labels.room = room;
      surface.labels.category = categories[static_cast<int>(piece.face)];
      surface.kind = SurfaceKind::Shell;
      building_.triangles.push_back(piece.triangle);
      building_.surfaces.push_back(surface);
    }
  }

  // Parts on the far side of y = 0 of the object's frame belong to room_behind.
  void
  addObject(const FurnitureModel& model,
            const ObjectInfo& info,
            std::uint32_t room_behind,
            SurfaceKind glass)
  {
    building_.objects.push_back(info);
    auto& object = building_.objects.back();
    object.first_part = next_part_;
    object.size = model.size;
    const Eigen::Affine3d pose =
        Eigen::Translation3d(info.position) *
        Eigen::AngleAxisd(info.rotation, Eigen::Vector3d::UnitZ());
    Surface surface;
    surface.labels.object = static_cast<std::uint32_t>(building_.objects.size());
    surface.labels.category = building_.category(info.category);
    for (const auto& part : model.parts) {
      object.part_names.push_back(part.name);
      surface.labels.part = next_part_++;
      surface.kind = part.glass ? glass : SurfaceKind::Solid;
      for (const auto& t : part.triangles) {
        const bool behind = t.a.y() + t.b.y() + t.c.y() < 0;
        surface.labels.room = behind ? room_behind : info.room;
        const auto moved = [&](const Eigen::Vector3f& p) -> Eigen::Vector3f {
          return (pose * p.cast<double>()).cast<float>();
        };
        building_.triangles.push_back({moved(t.a), moved(t.b), moved(t.c)});
        building_.surfaces.push_back(surface);
      }
    }
  }

private:
  Building& building_;
  std::uint32_t next_part_ = 1;
};

void
addOpening(Assembler& assemble,
           Building& building,
           const PlacedOpening& opening,
           double wall_thickness)
{
  constexpr double passable =
      60 * M_PI / 180; // a leaf this far open lets the sensor by
  const auto front = static_cast<std::uint32_t>(opening.front_room + 1);
  const auto back = static_cast<std::uint32_t>(opening.back_room + 1);
  assemble.addShell(reveal(opening, wall_thickness / 2), front);
  if (back > 0)
    assemble.addShell(reveal(opening, -wall_thickness / 2), back);
  const auto& plan = opening.plan;
  if (back > 0 && plan.sill == 0 && plan.kind != OpeningKind::Window &&
      (plan.kind == OpeningKind::Passage || plan.leaf_angle >= passable))
    building.doorways.push_back({opening.origin, plan.width});
  if (plan.kind == OpeningKind::Passage)
    return;
  ObjectInfo info;
  info.category = plan.kind == OpeningKind::Door ? "door" : "window";
  info.room = front;
  info.position = opening.origin;
  info.rotation = std::atan2(opening.along.y(), opening.along.x());
  const auto model = plan.kind == OpeningKind::Door
                         ? makeDoor(plan.width,
                                    plan.height,
                                    wall_thickness,
                                    plan.leaf_angle,
                                    plan.hinge_left)
                         : makeWindow(plan.width, plan.height, wall_thickness);
  assemble.addObject(model,
                     info,
                     back,
                     back > 0 ? SurfaceKind::InteriorGlass
                              : SurfaceKind::ExteriorGlass);
}

} // namespace

std::uint32_t
Building::category(const std::string& name) const
{
  const auto found = std::find(categories.begin(), categories.end(), name);
  if (found == categories.end())
    PCL_THROW_EXCEPTION(BadArgumentException, "there is no category '" << name << "'");
  return static_cast<std::uint32_t>(found - categories.begin());
}

Building
buildBuilding(const Plan& plan, const std::string& source)
{
  Building building;
  building.categories = categoryNames();
  building.rooms = makeRooms(plan, source);
  requireApart(building.rooms, source);
  const auto walls = placeOpenings(plan, building.rooms, source);
  Assembler assemble(building);
  for (std::size_t r = 0; r < building.rooms.size(); ++r) {
    std::vector<WallHole> holes;
    for (const auto& hole : walls.holes)
      if (hole.room == static_cast<int>(r))
        holes.push_back(hole);
    assemble.addShell(roomShell(building.rooms[r], holes),
                      static_cast<std::uint32_t>(r + 1));
  }
  for (const auto& opening : walls.openings)
    addOpening(assemble, building, opening, plan.wall_thickness);
  std::uint32_t item_number = 0;
  for (std::size_t s = 0; s < plan.storeys.size(); ++s)
    for (const auto& item : plan.storeys[s].furniture) {
      const std::uint32_t seed = item.seed.value_or(mixSeed(plan.seed, item_number++));
      const auto placed = place(item, seed, building.rooms, s, plan.storeys[s], source);
      ObjectInfo info;
      info.category = item.category;
      info.room = placed.room;
      info.position << item.at, placed.elevation;
      info.rotation = item.rotation;
      assemble.addObject(placed.model, info, placed.room, SurfaceKind::Solid);
    }
  return building;
}

} // namespace indoor
} // namespace pcl
