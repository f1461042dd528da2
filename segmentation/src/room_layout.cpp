/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "room_layout.h"

#include "opening_posts.h"
#include "room_levels.h"

#include <pcl/segmentation/room_outline.h>

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

} // namespace

void
addOpenings(const std::vector<Eigen::Vector3f>& points,
            const StoreySpace& space,
            BuildingRooms& building)
{
  const RoomMap& map = building.storeys.back();
  const double size = building.occupancy.grid.voxel_size;
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
                                   0.5 * (along - against) / size * found[k].along;
    RoomOpening opening;
    opening.room_a = room_of[found[k].a];
    opening.room_b = room_of[found[k].b];
    opening.position = on_floor(middle.x(), middle.y());
    opening.width = along + against;
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
  const auto levels = roomLevels(points, building);
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
        for (const auto& corner : corners) {
          line.push_back(on_floor(corner.x(), corner.y()));
          line.back().z() = levels[room.label].floor;
        }
        room.footprint.push_back(line);
      }
      room.height = levels[room.label].ceiling - levels[room.label].floor;
      room.volume = room.area * room.height;
    }
  }
}

} // namespace indoor
} // namespace pcl
