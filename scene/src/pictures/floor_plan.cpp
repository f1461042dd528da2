/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/floor_plan.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

constexpr double wall_thickness = 0.6;  // metres, at most, with what stands before it
constexpr double least_parallel = 0.94; // cosine, 20 degrees

PlanRoom
drawnRoom(const Room& room)
{
  PlanRoom drawn;
  drawn.label = room.label;
  drawn.area = room.area;
  for (const auto& line : room.footprint) {
    drawn.rings.emplace_back();
    for (const auto& corner : line)
      drawn.rings.back().emplace_back(corner.head<2>());
  }
  drawn.place = widestPlace(drawn.rings);
  return drawn;
}

std::vector<PlanLine>
sidesOf(const PlanRoom& room)
{
  std::vector<PlanLine> sides;
  for (const auto& ring : room.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      sides.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  return sides;
}

PlanOpening
drawnOpening(const RoomOpening& opening,
             std::size_t number,
             const PlanRoom& room_a,
             const PlanRoom& room_b)
{
  PlanOpening drawn;
  drawn.number = number;
  drawn.width = opening.width;
  drawn.middle = opening.position.head<2>();
  drawn.is_door = opening.width <= widest_door;
  auto rings = room_a.rings;
  rings.insert(rings.end(), room_b.rings.begin(), room_b.rings.end());
  drawn.along = directionOfSides(rings, drawn.middle, drawn.width);
  drawn.into = {-drawn.along.y(), drawn.along.x()};
  const auto& smaller = room_b.area < room_a.area ? room_b : room_a;
  if (!isInside(smaller.rings, drawn.middle + wall_thickness * drawn.into) &&
      isInside(smaller.rings, drawn.middle - wall_thickness * drawn.into))
    drawn.into = -drawn.into;
  return drawn;
}

/** What is left of a side beside an opening. */
std::vector<PlanLine>
without(const PlanLine& side, const PlanOpening& opening)
{
  const double length = (side.second - side.first).norm();
  const Eigen::Vector2d way = (side.second - side.first) / std::max(length, 1e-9);
  if (std::abs(way.dot(opening.along)) < least_parallel ||
      distanceToLine(side.first, side.second, opening.middle) > wall_thickness)
    return {side};
  const double middle = (opening.middle - side.first).dot(way);
  const double begin = middle - 0.5 * opening.width;
  const double end = middle + 0.5 * opening.width;
  std::vector<PlanLine> rest;
  if (begin > 0.0)
    rest.emplace_back(side.first, side.first + std::min(begin, length) * way);
  if (end < length)
    rest.emplace_back(side.first + std::max(end, 0.0) * way, side.second);
  return rest;
}

} // namespace

std::vector<PlanLine>
planWalls(const StoreyPlan& storey)
{
  std::vector<PlanLine> walls;
  for (const auto& room : storey.rooms) {
    auto sides = sidesOf(room);
    for (const auto& opening : storey.openings) {
      std::vector<PlanLine> rest;
      for (const auto& side : sides)
        for (const auto& part : without(side, opening))
          rest.push_back(part);
      sides = std::move(rest);
    }
    walls.insert(walls.end(), sides.begin(), sides.end());
  }
  return walls;
}

PlanRing
PlanBar::corners() const
{
  return bandAround(axis.first, axis.second, 0.5 * thickness, 0.5 * thickness);
}

void
addWall(const PlanBar& wall, StoreyPlan& storey)
{
  std::vector<PlanLine> parts = {wall.axis};
  for (const auto& opening : storey.openings) {
    std::vector<PlanLine> rest;
    for (const auto& part : parts)
      for (const auto& piece : without(part, opening))
        rest.push_back(piece);
    parts = std::move(rest);
  }
  for (const auto& part : parts)
    storey.bodies.push_back({part, wall.thickness});
}

void
addWindow(const Eigen::Vector2d& middle,
          const Eigen::Vector2d& along,
          double width,
          double thickness,
          StoreyPlan& storey)
{
  constexpr double usual = 0.12; // metres: a frame, where one side of the wall was seen
  const Eigen::Vector2d half = 0.5 * width * along;
  storey.windows.push_back(
      {{middle - half, middle + half}, thickness > 0.0 ? thickness : usual});
}

PlanLine
PlanOpening::threshold() const
{
  return {middle - 0.5 * width * along, middle + 0.5 * width * along};
}

Eigen::Vector2d
PlanOpening::leafEnd() const
{
  return threshold().first + width * into;
}

FloorPlan
floorPlan(const BuildingRooms& building, const std::vector<PlanObject>& objects)
{
  FloorPlan plan;
  plan.storeys.resize(building.maps.size());
  std::vector<PlanRoom> rooms;
  for (const auto& room : building.rooms) {
    rooms.push_back(drawnRoom(room));
    plan.storeys[room.storey].rooms.push_back(rooms.back());
    for (const auto& ring : rooms.back().rings)
      for (const auto& corner : ring)
        plan.box.extend(corner);
  }
  for (std::size_t i = 0; i < building.openings.size(); ++i) {
    const auto& opening = building.openings[i];
    auto& storey = plan.storeys[building.rooms[opening.room_a - 1].storey];
    storey.openings.push_back(drawnOpening(
        opening, i + 1, rooms[opening.room_a - 1], rooms[opening.room_b - 1]));
  }
  for (auto& storey : plan.storeys)
    storey.walls = planWalls(storey);
  for (const auto& object : objects)
    plan.storeys.at(object.storey).objects.push_back(object);
  for (const auto& station : building.stations)
    if (station.room > 0)
      plan.storeys.at(building.rooms[station.room - 1].storey)
          .stations.push_back(station.position.head<2>());
  if (plan.box.isEmpty())
    plan.box = {Eigen::Vector2d::Zero(), Eigen::Vector2d(1.0, 1.0)};
  return plan;
}

void
addNames(const std::vector<std::string>& names, FloorPlan& plan)
{
  for (auto& storey : plan.storeys)
    for (auto& room : storey.rooms)
      if (room.label > 0 && room.label <= names.size())
        room.name = names[room.label - 1];
}

void
addModel(const BuildingModel& model, FloorPlan& plan)
{
  for (const auto& wall : model.walls)
    if (wall.thickness > 0.0)
      addWall({{wall.begin, wall.end}, wall.thickness}, plan.storeys.at(wall.storey));
  for (const auto& opening : model.openings)
    if (opening.kind == ModelOpeningKind::Window)
      addWindow(opening.position.head<2>(),
                opening.along,
                opening.width,
                opening.wall < model.walls.size() ? model.walls[opening.wall].thickness
                                                  : 0.0,
                plan.storeys.at(opening.storey));
}

} // namespace pcl::indoor::tool
