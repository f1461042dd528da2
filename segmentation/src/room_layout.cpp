/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "room_layout.h"

#include <pcl/segmentation/room_outline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace pcl {
namespace indoor {
namespace {

/** Turns places on the map of a storey, pixels, into places on its floor. */
class FloorPlane {
public:
  FloorPlane(const OccupancyGrid& occupancy, const RoomMap& map)
  : occupancy_(occupancy)
  , layer_(map.first_layer + map.range.begin + 0.5)
  {}

  Eigen::Vector3d
  operator()(double x, double y) const
  {
    const VoxelGrid<std::uint8_t>& grid = occupancy_.grid;
    return occupancy_.toCloud(grid.origin +
                              grid.voxel_size * Eigen::Vector3d(x, y, layer_));
  }

private:
  const OccupancyGrid& occupancy_;
  double layer_; ///< middle of the floor's voxels
};

/** Where the points of each room lie on the map in the slab below the ceiling, where
 * nearly all that is seen is wall; pixels, per label of a room. */
std::vector<std::vector<Eigen::Vector2d>>
wallPoints(const std::vector<Eigen::Vector3f>& points, const BuildingRooms& building)
{
  const VoxelGrid<std::uint8_t>& grid = building.occupancy.grid;
  const Eigen::Matrix2d turn = building.occupancy.turn();
  std::vector<std::vector<Eigen::Vector2d>> places(building.rooms.size() + 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t label = building.point_labels[i];
    if (label == 0)
      continue;
    const RoomMap& map = building.storeys[building.rooms[label - 1].storey];
    const std::int32_t cell = building.occupancy.cells[i];
    const int below = map.ceiling.values[cell / grid.shape.nz] + map.first_layer -
                      cell % grid.shape.nz;
    if (below < map.slab.first || below > map.slab.last)
      continue;
    const Eigen::Vector2d place =
        turn * points[i].head<2>().cast<double>() - grid.origin.head<2>();
    places[label].push_back(place / grid.voxel_size);
  }
  return places;
}

/** Tells how wide openings are by the points of their posts: a voxel is clear or not,
 * and each post takes up to one of a door's width. */
class OpeningPosts {
public:
  OpeningPosts(const std::vector<RegionOpening>& openings,
               const OccupancyGrid& occupancy,
               const RoomMap& map)
  : openings_(openings)
  , occupancy_(occupancy)
  , turn_(occupancy.turn())
  , floor_(map.first_layer + map.range.begin)
  , is_near_(map.labels.size(), 0)
  , ends_(openings.size())
  {
    const GridShape& shape = occupancy.grid.shape;
    for (std::size_t k = 0; k < openings.size(); ++k) {
      const auto& [x, y] = std::make_pair(openings[k].x, openings[k].y);
      const double radius = std::hypot(halfWidth(k) + reach, reach);
      for (int u = std::max(0, int(x - radius)); u < shape.nx && u <= x + radius; ++u)
        for (int v = std::max(0, int(y - radius)); v < shape.ny && v <= y + radius;
             ++v) {
          const std::size_t pixel = static_cast<std::size_t>(u) * shape.ny + v;
          is_near_[pixel] = 1;
          near_.emplace_back(pixel, k);
        }
    }
    std::sort(near_.begin(), near_.end());
  }

  /** Look at a point of the building. */
  void
  add(const Eigen::Vector3f& point, std::int32_t cell)
  {
    const std::size_t pixel = cell / occupancy_.grid.shape.nz;
    if (cell < 0 || !is_near_[pixel])
      return;
    const VoxelGrid<std::uint8_t>& grid = occupancy_.grid;
    const double height = point.z() - grid.origin.z() - floor_ * grid.voxel_size;
    if (height < lowest || height > highest)
      return;
    const Eigen::Vector2d place =
        (turn_ * point.head<2>().cast<double>() - grid.origin.head<2>()) /
        grid.voxel_size;
    for (auto it = std::lower_bound(
             near_.begin(), near_.end(), std::make_pair(pixel, std::size_t{0}));
         it != near_.end() && it->first == pixel;
         ++it) {
      const RegionOpening& opening = openings_[it->second];
      const Eigen::Vector2d from(place.x() - opening.x, place.y() - opening.y);
      const double along = opening.along.dot(from);
      const double beside = from.x() * opening.along.y() - from.y() * opening.along.x();
      const double beyond = std::abs(along) - halfWidth(it->second);
      if (std::abs(beside) <= reach && std::abs(beyond) <= reach)
        ends_[it->second][along > 0].push_back(std::abs(along));
    }
  }

  /** The ends of an opening, pixels from its middle along it and against it. */
  std::pair<double, double>
  ends(std::size_t opening)
  {
    return {end(opening, 1), end(opening, 0)};
  }

private:
  // Posts are looked for up to 2 pixels beside the border and from the clear width's
  // ends, between 0.3 m and 1.6 m above the floor.
  static constexpr double reach = 2.0, lowest = 0.3, highest = 1.6;

  double
  halfWidth(std::size_t opening) const
  {
    return 0.5 * openings_[opening].width / occupancy_.grid.voxel_size;
  }

  /** Where the post begins: only some outliers lie before it. */
  double
  end(std::size_t opening, int side)
  {
    constexpr std::size_t outliers = 5;
    auto& places = ends_[opening][side];
    if (places.size() <= outliers)
      return halfWidth(opening);
    std::nth_element(places.begin(), places.begin() + outliers, places.end());
    return places[outliers];
  }

  const std::vector<RegionOpening>& openings_;
  const OccupancyGrid& occupancy_;
  Eigen::Matrix2d turn_;
  double floor_;                                          ///< layers
  std::vector<std::uint8_t> is_near_;                     ///< per pixel
  std::vector<std::pair<std::size_t, std::size_t>> near_; ///< pixels and openings
  std::vector<std::array<std::vector<double>, 2>> ends_;
};

} // namespace

void
addOpenings(const std::vector<Eigen::Vector3f>& points,
            const StoreySpace& space,
            BuildingRooms& building)
{
  const RoomMap& map = building.storeys.back();
  const auto& room_of = building.room_of.back();
  const FloorPlane on_floor(building.occupancy, map);
  const auto found = regionOpenings(
      space.occupancy, map.range, map.ceiling, map.labels, map.free_labels);
  OpeningPosts posts(found, building.occupancy, map);
  for (std::size_t i = 0; i < points.size(); ++i)
    posts.add(points[i], building.occupancy.cells[i]);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto [along, against] = posts.ends(k);
    const Eigen::Vector2d middle = Eigen::Vector2d(found[k].x, found[k].y) +
                                   0.5 * (along - against) * found[k].along;
    RoomOpening opening;
    opening.room_a = room_of[found[k].a];
    opening.room_b = room_of[found[k].b];
    opening.position = on_floor(middle.x(), middle.y());
    opening.width = (along + against) * building.occupancy.grid.voxel_size;
    opening.area = found[k].area * opening.width / found[k].width;
    building.openings.push_back(opening);
  }
}

void
addFootprints(const std::vector<Eigen::Vector3f>& points, BuildingRooms& building)
{
  constexpr double tolerance = 1.5; // pixels: straight walls at any angle become lines
  const double size = building.occupancy.grid.voxel_size;
  const auto walls = wallPoints(points, building);
  for (std::size_t s = 0; s < building.storeys.size(); ++s) {
    const RoomMap& map = building.storeys[s];
    const FloorPlane on_floor(building.occupancy, map);
    const auto outlines = traceOutlines(map.free_labels, map.room_count);
    for (std::int32_t label = 1; label <= map.room_count; ++label) {
      Room& room = building.rooms[building.room_of[s][label] - 1];
      room.area = 0.0;
      const WallPoints of_room(walls[room.label]);
      for (const auto& ring : outlines[label]) {
        const auto corners = moveToWalls(simplifyOutline(ring, tolerance), of_room);
        room.area += size * size * signedArea(corners);
        std::vector<Eigen::Vector3d> line;
        for (const auto& corner : corners)
          line.push_back(on_floor(corner.x(), corner.y()));
        room.footprint.push_back(line);
      }
      room.volume = room.area * room.height;
    }
  }
}

} // namespace indoor
} // namespace pcl
