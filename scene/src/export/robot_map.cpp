/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/robot_map.h"

#include "export/plan_boxes.h"
#include "files/tool_error.h"
#include "text/number_text.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

constexpr double margin = 0.5;          // metres around the storey
constexpr double around_free = 0.1;     // metres that are occupied
constexpr double threshold_depth = 0.1; // metres that a way reaches into rooms
constexpr double head_height = 1.8;     // metres: what hangs higher is in no one's way
constexpr double step_height = 0.05;    // metres: what is lower is driven over
constexpr double most_cells = 4e8;

RobotMap
emptyMap(const SavedScene& scene, std::uint32_t storey, double resolution)
{
  Eigen::AlignedBox2d box;
  const auto extend = [&box](const PlanRing& ring) {
    for (const auto& corner : ring)
      box.extend(corner);
  };
  for (const auto& room : scene.rooms)
    if (room.storey == storey)
      for (const auto& ring : room.rings)
        extend(ring);
  for (const auto& wall : scene.walls)
    if (wall.storey == storey)
      extend(wallBox(wall));
  RobotMap map;
  map.resolution = resolution;
  if (box.isEmpty())
    return map;
  map.origin = resolution * ((box.min().array() - margin) / resolution).floor();
  const Eigen::Array2d sides = (box.max() - map.origin).array() + margin;
  const Eigen::Array2d cells = (sides / resolution).ceil();
  if (!(cells.prod() <= most_cells))
    throw ToolError("-resolution: the map of storey " + std::to_string(storey) +
                    " would have more than 400 million cells");
  map.nx = static_cast<int>(cells.x());
  map.ny = static_cast<int>(cells.y());
  map.cells.assign(static_cast<std::size_t>(map.nx) * map.ny, UnknownCell);
  return map;
}

/** Where the sides of rings cross a row of cells, in cells from the left. */
std::vector<double>
crossings(const RobotMap& map, const std::vector<PlanRing>& rings, int row)
{
  const double y = map.origin.y() + (row + 0.5) * map.resolution;
  std::vector<double> places;
  forEachSideAcross(rings, y, [&](const auto& a, const auto& b) {
    places.push_back((xOfSide(a, b, y) - map.origin.x()) / map.resolution);
  });
  std::sort(places.begin(), places.end());
  return places;
}

/** Give the cells whose middles are inside rings a value, those of some value only. */
void
fill(RobotMap& map, const std::vector<PlanRing>& rings, MapCell value, int only = -1)
{
  double low = INFINITY, high = -INFINITY;
  for (const auto& ring : rings)
    for (const auto& corner : ring) {
      low = std::min(low, (corner.y() - map.origin.y()) / map.resolution);
      high = std::max(high, (corner.y() - map.origin.y()) / map.resolution);
    }
  const int first = static_cast<int>(std::clamp<double>(std::floor(low), 0, map.ny));
  const int last = static_cast<int>(std::clamp<double>(std::ceil(high), 0, map.ny));
  for (int row = first; row < last; ++row) {
    const auto places = crossings(map, rings, row);
    auto* cells = map.cells.data() + static_cast<std::size_t>(row) * map.nx;
    for (std::size_t i = 0; i + 1 < places.size(); i += 2) {
      const int begin =
          static_cast<int>(std::clamp<double>(std::ceil(places[i] - 0.5), 0, map.nx));
      const int end = static_cast<int>(
          std::clamp<double>(std::ceil(places[i + 1] - 0.5), 0, map.nx));
      for (int x = begin; x < end; ++x)
        if (only < 0 || cells[x] == only)
          cells[x] = value;
    }
  }
}

/** A way is as wide as its opening, and never less than a cell. */
void
openWays(RobotMap& map, const SavedScene& scene, std::uint32_t storey)
{
  for (const auto& opening : scene.openings)
    if (opening.storey == storey && opening.kind != ModelOpeningKind::Window)
      fill(map,
           {openingBox(openingPlace(scene, opening),
                       std::max(opening.width, map.resolution),
                       threshold_depth)},
           FreeCell);
}

void
closeDoors(RobotMap& map, const SavedScene& scene, std::uint32_t storey)
{
  for (const auto& opening : scene.openings)
    if (opening.storey == storey && opening.kind == ModelOpeningKind::Door &&
        !opening.is_open) {
      const auto way = openingPlace(scene, opening);
      const double more = std::max(0.0, map.resolution - std::min(way.left, way.right));
      fill(map, {openingBox(way, opening.width, more)}, OccupiedCell);
    }
}

void
addFurniture(RobotMap& map, const SavedScene& scene, std::uint32_t storey)
{
  for (const auto& object : scene.objects) {
    if (object.is_structure || object.storey != storey || object.name == "door")
      continue;
    const double floor = object.room > 0 ? scene.rooms[object.room - 1].floor
                                         : scene.storeys[storey].floor;
    const double foot = object.box.center.z() - 0.5 * object.box.size.z() - floor;
    if (foot < head_height && foot + object.box.size.z() > step_height)
      fill(map, {boxFromAbove(object.box)}, OccupiedCell, FreeCell);
  }
}

/** What is unknown beside what is free becomes a wall. */
void
closeBorders(RobotMap& map)
{
  const int reach =
      std::max(1, static_cast<int>(std::lround(around_free / map.resolution)));
  for (int y = 0; y < map.ny; ++y)
    for (int x = 0; x < map.nx; ++x) {
      const bool is_inside = x > 0 && y > 0 && x + 1 < map.nx && y + 1 < map.ny;
      if (map.at(x, y) != FreeCell ||
          (is_inside && map.at(x - 1, y) == FreeCell && map.at(x + 1, y) == FreeCell &&
           map.at(x, y - 1) == FreeCell && map.at(x, y + 1) == FreeCell))
        continue;
      for (int v = std::max(0, y - reach); v <= std::min(map.ny - 1, y + reach); ++v)
        for (int u = std::max(0, x - reach); u <= std::min(map.nx - 1, x + reach); ++u)
          if (auto& cell = map.cells[static_cast<std::size_t>(v) * map.nx + u];
              cell == UnknownCell)
            cell = OccupiedCell;
    }
}

} // namespace

RobotMap
robotMap(const SavedScene& scene,
         std::uint32_t storey,
         double resolution,
         bool with_furniture)
{
  auto map = emptyMap(scene, storey, resolution);
  if (map.cells.empty())
    return map;
  for (const auto& wall : scene.walls)
    if (wall.storey == storey)
      fill(map, {wallBox(wall)}, OccupiedCell);
  for (const auto& room : scene.rooms)
    if (room.storey == storey)
      fill(map, room.rings, FreeCell);
  openWays(map, scene, storey);
  closeBorders(map);
  if (with_furniture) {
    closeDoors(map, scene, storey);
    addFurniture(map, scene, storey);
  }
  return map;
}

std::string
pgmBytes(const RobotMap& map)
{
  std::string bytes =
      "P5\n" + std::to_string(map.nx) + " " + std::to_string(map.ny) + "\n255\n";
  for (int y = map.ny; y-- > 0;)
    bytes.append(reinterpret_cast<const char*>(map.cells.data()) +
                     static_cast<std::size_t>(y) * map.nx,
                 map.nx);
  return bytes;
}

std::string
mapYaml(const RobotMap& map, const std::string& image)
{
  std::string quoted;
  for (const char letter : image)
    quoted += letter == '\'' ? "''" : std::string(1, letter);
  return "image: '" + quoted +
         "'\nmode: trinary\nresolution: " + numberText(map.resolution) + "\norigin: [" +
         numberText(std::round(map.origin.x() * 1e6) / 1e6) + ", " +
         numberText(std::round(map.origin.y() * 1e6) / 1e6) +
         ", 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

} // namespace pcl::indoor::tool
