/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/placement.h"

#include "plan/fail_at.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace pcl::indoor {

namespace {

constexpr double into_wall = 0.05; // metres that furniture may reach into a wall

std::array<Eigen::Vector2d, 4>
footprint(const FurniturePlan& item,
          const Eigen::Vector2d& at,
          const Eigen::Vector3d& size)
{
  const Eigen::Rotation2Dd turn(item.rotation);
  const double x = size.x() / 2, y = size.y() / 2;
  return {at + turn * Eigen::Vector2d(-x, -y),
          at + turn * Eigen::Vector2d(x, -y),
          at + turn * Eigen::Vector2d(x, y),
          at + turn * Eigen::Vector2d(-x, y)};
}

[[noreturn]] void
failFurniture(const std::string& source,
              const StoreyPlan& storey,
              const FurniturePlan& item,
              const std::string& problem)
{
  failAt(source, "furniture", storey, item.category, item.at, problem);
}

// The number of the room of a storey in which a place lies; 0: none.
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

std::uint32_t
roomNamed(const std::vector<RoomInfo>& rooms, const std::string& name)
{
  for (std::size_t r = 0; r < rooms.size(); ++r)
    if (rooms[r].name == name)
      return static_cast<std::uint32_t>(r + 1);
  return 0;
}

bool
leans(const Building& building, const RoomInfo& room)
{
  return building.lean != Eigen::Vector2d::Zero() ||
         std::any_of(room.drift.begin(), room.drift.end(), [](const auto& d) {
           return d != Eigen::Vector2d::Zero();
         });
}

// The way from a place at a height to the room, zero if it lies in it.
Eigen::Vector2d
wayInside(const Building& building,
          const RoomInfo& room,
          const Eigen::Vector2d& at,
          double z)
{
  const Polygon walls = room.polygonAt(z);
  const Eigen::Vector2d drawn = at - z * building.lean;
  if (contains(walls, drawn) || distanceToBoundary(walls, drawn) <= into_wall)
    return Eigen::Vector2d::Zero();
  Eigen::Vector2d nearest = walls[0];
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const auto& a = walls[i];
    const Eigen::Vector2d edge = walls[(i + 1) % walls.size()] - a;
    const double t = std::clamp((drawn - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    if ((a + t * edge - drawn).norm() < (nearest - drawn).norm())
      nearest = a + t * edge;
  }
  return nearest - drawn;
}

// Upright furniture moves off the walls that lean over it, the farthest corner first.
Eigen::Vector2d
offLeaningWalls(const FurniturePlan& item,
                const Building& building,
                const RoomInfo& room,
                Eigen::Vector2d at,
                const Eigen::Vector3d& size,
                double low)
{
  constexpr int most_moves = 8; // a corner of the room takes two
  for (int move = 0; move < most_moves; ++move) {
    Eigen::Vector2d farthest = Eigen::Vector2d::Zero();
    for (const auto& corner : footprint(item, at, size))
      for (const double z : {low, low + size.z()}) {
        const auto way = wayInside(building, room, corner, z);
        if (way.norm() > farthest.norm())
          farthest = way;
      }
    at += farthest;
  }
  return at;
}

FurnitureModel
makeModel(const FurniturePlan& item,
          std::uint32_t seed,
          const std::optional<Eigen::Vector3d>& size)
{
  return item.half_turn ? makeHalfTurnStairs(*size)
                        : makeFurniture(item.category, seed, size, item.variant);
}

// Is there no ceiling above the place?
bool
inWell(const Building& building, std::uint32_t room, const Eigen::Vector2d& at)
{
  return std::any_of(
      building.wells.begin(), building.wells.end(), [&](const auto& well) {
        return well.lower == room && contains(well.polygon, at);
      });
}

} // namespace

FurniturePlacement
placeFurniture(const FurniturePlan& item,
               std::uint32_t seed,
               const Building& building,
               std::size_t storey_number,
               const StoreyPlan& storey,
               const std::string& source)
{
  const auto& rooms = building.rooms;
  FurniturePlacement result;
  const std::uint32_t named = roomNamed(rooms, item.room);
  if (!item.room.empty() && named == 0)
    failFurniture(source, storey, item, "names the unknown room '" + item.room + "'");
  const std::uint32_t here = roomOf(rooms, storey_number, item.at);
  const std::uint32_t stands_in = result.stands_in = here > 0 ? here : named;
  result.room = named > 0 ? named : here;
  if (stands_in == 0)
    failFurniture(source, storey, item, "stands in no room");
  const auto& room = rooms[stands_in - 1];
  result.model = makeModel(item, seed, item.size);
  double lowest = room.ceiling.heightAt(item.at), highest = lowest;
  for (const auto& corner : footprint(item, item.at, result.model.size)) {
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
    result.model = makeModel(item, seed, size);
  }
  const bool hangs = item.category == "beam" || item.category == "ceiling_lamp";
  const double height = result.model.size.z();
  const double floor = storey.elevation;
  const double above = item.elevation.value_or(hangs ? lowest - height : 0.0);
  const double low = floor + above;
  if (low < room.floor)
    failFurniture(source, storey, item, "stands below the floor (elevation)");
  if (low + height > room.floor + highest + 0.02 &&
      !inWell(building, stands_in, item.at))
    failFurniture(source, storey, item, "is higher than its room");
  Eigen::Vector2d at = item.at + low * building.lean;
  if (leans(building, room))
    at = offLeaningWalls(item, building, room, at, result.model.size, low);
  result.position << at, low;
  return result;
}

} // namespace pcl::indoor
