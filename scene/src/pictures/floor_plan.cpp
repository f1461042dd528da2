/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/floor_plan.h"

#include <Eigen/Geometry> // for AlignedBox2i

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::indoor::tool {
namespace {

constexpr double wall_thickness = 0.6;  // metres, at most, with what stands before it
constexpr double least_parallel = 0.94; // cosine, 20 degrees

/** The boxes of the rooms' pixels, so that nobody looks at the whole map for each. */
std::vector<Eigen::AlignedBox2i>
boxesOfRooms(const BuildingRooms& building)
{
  std::vector<Eigen::AlignedBox2i> boxes(building.rooms.size() + 1); // per label
  for (std::size_t storey = 0; storey < building.maps.size(); ++storey) {
    const auto& labels = building.maps[storey].free_labels;
    for (int x = 0; x < labels.nx; ++x)
      for (int y = 0; y < labels.ny; ++y)
        if (labels.at(x, y) > 0)
          boxes[building.room_of[storey][labels.at(x, y)]].extend(
              Eigen::Vector2i(x, y));
  }
  return boxes;
}

/** The middle of that pixel, among those where a room is about widest, which lies
 * nearest to their mean.
 * \param[in] box of the room's pixels */
Eigen::Vector2d
widestPlace(const BuildingRooms& building,
            const Room& room,
            const Eigen::AlignedBox2i& box)
{
  constexpr float about = 0.95f;
  const auto& map = building.maps[room.storey];
  const auto& room_of = building.room_of[room.storey];
  std::vector<Eigen::Vector2d> pixels;
  std::vector<float> widths;
  for (int x = box.min().x(); x <= box.max().x(); ++x)
    for (int y = box.min().y(); y <= box.max().y(); ++y)
      if (room_of[map.free_labels.at(x, y)] == room.label) {
        pixels.emplace_back(x, y);
        widths.push_back(map.field.at(x, y));
      }
  if (pixels.empty())
    return building.grid.toBuilding(Eigen::Vector3d::Zero()).head<2>();
  const float enough = about * *std::max_element(widths.begin(), widths.end());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  std::size_t count = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (widths[i] >= enough) {
      mean += pixels[i];
      ++count;
    }
  mean /= static_cast<double>(count);
  Eigen::Vector2d place = mean;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (widths[i] >= enough && (pixels[i] - mean).squaredNorm() < nearest) {
      nearest = (pixels[i] - mean).squaredNorm();
      place = pixels[i];
    }
  const auto center =
      building.grid.center(static_cast<int>(place.x()), static_cast<int>(place.y()));
  return building.grid.toBuilding(center).head<2>();
}

PlanRoom
drawnRoom(const BuildingRooms& building,
          const Room& room,
          const Eigen::AlignedBox2i& box)
{
  PlanRoom drawn{room.label, room.area, widestPlace(building, room, box), {}, {}};
  for (const auto& line : room.footprint) {
    drawn.rings.emplace_back();
    for (const auto& corner : line)
      drawn.rings.back().emplace_back(corner.head<2>());
  }
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

double
distance(const PlanLine& line, const Eigen::Vector2d& place)
{
  return distanceToLine(line.first, line.second, place);
}

/** The direction of the wall that an opening is in: that of the longest side, up to
 * twice as long as the opening, of those that are about as near as the nearest. */
Eigen::Vector2d
directionAt(const PlanOpening& opening, const std::vector<PlanLine>& sides)
{
  constexpr double about = 0.3; // metres
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& side : sides)
    nearest = std::min(nearest, distance(side, opening.middle));
  double longest = 0.0;
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();
  for (const auto& side : sides) {
    const double length =
        std::min((side.second - side.first).norm(), 2.0 * opening.width);
    if (distance(side, opening.middle) <= nearest + about && length > longest) {
      longest = length;
      along = (side.second - side.first).normalized();
    }
  }
  return along;
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
  auto sides = sidesOf(room_a);
  const auto others = sidesOf(room_b);
  sides.insert(sides.end(), others.begin(), others.end());
  drawn.along = directionAt(drawn, sides);
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
      distance(side, opening.middle) > wall_thickness)
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
  const auto boxes = boxesOfRooms(building);
  for (const auto& room : building.rooms) {
    rooms.push_back(drawnRoom(building, room, boxes[room.label]));
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
