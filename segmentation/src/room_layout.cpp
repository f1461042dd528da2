/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "room_layout.h"

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
    const Eigen::Vector3d place =
        building.occupancy.toGrid(points[i].cast<double>()) - grid.origin;
    places[label].push_back(place.head<2>() / grid.voxel_size);
  }
  return places;
}

} // namespace

void
addOpenings(const StoreySpace& space, BuildingRooms& building)
{
  const RoomMap& map = building.storeys.back();
  const auto& room_of = building.room_of.back();
  const FloorPlane on_floor(building.occupancy, map);
  for (const auto& found : regionOpenings(
           space.occupancy, map.range, map.ceiling, map.labels, map.free_labels)) {
    RoomOpening opening;
    opening.room_a = room_of[found.a];
    opening.room_b = room_of[found.b];
    opening.position = on_floor(found.x, found.y);
    opening.width = found.width;
    opening.area = found.area;
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
      for (const auto& ring : outlines[label]) {
        const auto corners =
            moveToWalls(simplifyOutline(ring, tolerance), walls[room.label]);
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
