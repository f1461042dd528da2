/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/outline/room_layout.h"

#include "rooms/dimensions.h"
#include "rooms/map/region_evidence.h"
#include "rooms/outline/opening_posts.h"
#include "rooms/outline/room_levels.h"

#include "rooms/outline/room_footprint.h"
#include "rooms/outline/room_outline.h"

#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include <vector>

namespace pcl::indoor {
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
    const VoxelBits& grid = occupancy_.grid;
    return occupancy_.toBuilding(grid.origin +
                                 grid.voxel_size * Eigen::Vector3d(x, y, layer_));
  }

private:
  const OccupancyGrid& occupancy_;
  double layer_; ///< middle of the floor's voxels
};

/** Columns of which at least three quarters are occupied between the floor and the
 * slab, in themselves or beside them: walls, also behind low furniture, but nothing
 * that hangs.
 */
PixelMap<std::uint8_t>
uprightColumns(const OccupancyGrid& occupancy, const RoomMap& map)
{
  const GridShape& shape = occupancy.grid.shape;
  auto upright = PixelMap<std::uint8_t>::filled(shape.nx, shape.ny, 0);
  for (int x = 1; x + 1 < shape.nx; ++x)
    for (int y = 1; y + 1 < shape.ny; ++y) {
      if (!map.blocked.at(x, y))
        continue;
      const int begin = map.first_layer + map.range.begin + 1;
      const int end = map.first_layer + map.ceiling.at(x, y) - map.slab.last;
      int occupied = 0;
      for (int z = begin; z < end; ++z) {
        bool is_occupied = false;
        for (int u = x - 1; u <= x + 1; ++u)
          for (int v = y - 1; v <= y + 1; ++v)
            is_occupied |= occupancy.grid.at(u, v, z);
        occupied += is_occupied;
      }
      upright.at(x, y) = 4 * occupied >= 3 * (end - begin);
    }
  return upright;
}

/** Numbers of points, per label of a room. */
struct SlabPoints {
  std::vector<std::vector<std::uint32_t>> walls, all;
};

/** The points of each room in the slab below the ceiling, where nearly all that is seen
 * is wall. */
SlabPoints
slabPoints(const std::vector<Eigen::Vector3f>& points, const DetailedBuilding& building)
{
  const VoxelBits& grid = building.occupancy.grid;
  std::vector<PixelMap<std::uint8_t>> upright;
  for (const RoomMap& map : building.room_maps)
    upright.push_back(uprightColumns(building.occupancy, map));
  SlabPoints in_slab;
  in_slab.walls.resize(building.rooms.size() + 1);
  in_slab.all.resize(building.rooms.size() + 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t label = building.point_labels[i];
    if (label == 0)
      continue;
    const std::uint32_t storey = building.rooms[label - 1].storey;
    const RoomMap& map = building.room_maps[storey];
    const std::int32_t cell = building.occupancy.cells[i];
    const std::int32_t pixel = cell / grid.shape.nz;
    if (!map.inSlab(pixel, cell % grid.shape.nz))
      continue;
    in_slab.all[label].push_back(static_cast<std::uint32_t>(i));
    if (upright[storey].values[pixel])
      in_slab.walls[label].push_back(static_cast<std::uint32_t>(i));
  }
  return in_slab;
}

/** Where points lie on the map, pixels. */
std::vector<Eigen::Vector2d>
placesOf(const std::vector<std::uint32_t>& numbers,
         const std::vector<Eigen::Vector3f>& points,
         const OccupancyGrid& occupancy)
{
  const VoxelBits& grid = occupancy.grid;
  const Eigen::Matrix2d turn = occupancy.turn();
  std::vector<Eigen::Vector2d> places;
  places.reserve(numbers.size());
  for (const std::uint32_t i : numbers)
    places.emplace_back(
        (turn * points[i].head<2>().cast<double>() - grid.origin.head<2>()) /
        grid.voxel_size);
  return places;
}

/** Whether a place lies within a ring: a ray from it crosses the ring oddly often. */
bool
isWithin(const Eigen::Vector2d& place, const std::vector<Eigen::Vector2d>& ring)
{
  bool within = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if ((a.y() > place.y()) != (b.y() > place.y()) &&
        place.x() < a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      within = !within;
  }
  return within;
}

/** Whether a part of the map holds no free space of other rooms. */
bool
isFreeOfOthers(const std::vector<Eigen::Vector2d>& part,
               const PixelMap<std::int32_t>& free_labels,
               std::int32_t label)
{
  Eigen::AlignedBox2d box;
  for (const auto& corner : part)
    box.extend(corner);
  const Eigen::Vector2i first = box.min().array().floor().max(0.0).cast<int>();
  const int end_x =
      std::min(free_labels.nx, static_cast<int>(std::ceil(box.max().x())));
  const int end_y =
      std::min(free_labels.ny, static_cast<int>(std::ceil(box.max().y())));
  for (int x = first.x(); x < end_x; ++x)
    for (int y = first.y(); y < end_y; ++y) {
      const std::int32_t here = free_labels.at(x, y);
      if (here > 0 && here != label && isWithin({x + 0.5, y + 0.5}, part))
        return false;
    }
  return true;
}

/** The rise of a passage towards what was seen in both of its regions: where they show
 * no ceiling, they show no lintel, either, and passages seem to reach up. */
double
seenRise(const RegionOpening& opening,
         const std::vector<LevelSides>& levels,
         const UnseenSides& unseen)
{
  const LevelSides &a = levels[opening.a], &b = levels[opening.b];
  const auto areSeen = [](double one, double other) {
    return std::min(one, other) >= UnseenSides::least_seen;
  };
  const bool has_floors =
      unseen.floorIsMostlySeen() && areSeen(a.floorShare(), b.floorShare());
  const bool has_ceilings =
      unseen.ceilingIsMostlySeen() && areSeen(a.ceilingShare(), b.ceilingShare());
  return std::clamp(
      opening.rise, has_floors ? -INFINITY : 0.0, has_ceilings ? INFINITY : 0.0);
}

} // namespace

void
addOpenings(const std::vector<Eigen::Vector3f>& points,
            const StoreySpace& space,
            int threads,
            DetailedBuilding& building)
{
  const RoomMap& map = building.room_maps.back();
  const double size = building.occupancy.grid.voxel_size;
  const auto& room_of = building.room_of.back();
  const FloorPlane on_floor(building.occupancy, map);
  const auto found = regionOpenings(borderMap(map, space.occupancy));
  const OpeningPosts unseen(found, building.occupancy, map);
  OpeningPosts posts = unseen;
  parallelFor(
      static_cast<std::ptrdiff_t>(points.size()),
      usefulThreads(threads, points.size(), 100000),
      10000,
      [&] { return unseen; },
      [&](OpeningPosts& own, std::ptrdiff_t i) {
        own.add(points[i], building.occupancy.cells[i]);
      },
      [&](const OpeningPosts& own) { posts.add(own); });
  const std::vector<LevelSides> levels = levelSides(space.occupancy, map);
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
    opening.rise = seenRise(found[k], levels, building.interior.unseen);
    building.openings.push_back(opening);
  }
}

void
addFootprints(const std::vector<Eigen::Vector3f>& points,
              int threads,
              DetailedBuilding& building)
{
  constexpr double tolerance = 1.5; // pixels: straight walls at any angle become lines
  const double size = building.occupancy.grid.voxel_size;
  std::vector<RoomLevels> levels;
  SlabPoints in_slab;
  parallelFor(2, std::min(2, threadCount(threads)), 1, [&](std::ptrdiff_t task) {
    if (task == 0)
      levels = roomLevels(points, building);
    else
      in_slab = slabPoints(points, building);
  });
  for (std::size_t s = 0; s < building.room_maps.size(); ++s) {
    const RoomMap& map = building.room_maps[s];
    const FloorPlane on_floor(building.occupancy, map);
    const auto outlines = traceOutlines(map.free_labels, map.room_count);
    for (std::int32_t label = 1; label <= map.room_count; ++label) {
      Room& room = building.rooms[building.room_of[s][label] - 1];
      room.area = 0.0;
      FootprintWalls behind;
      behind.walls =
          WallPoints(placesOf(in_slab.walls[room.label], points, building.occupancy));
      behind.others =
          WallPoints(placesOf(in_slab.all[room.label], points, building.occupancy));
      // cupboards and ducts are hardly deeper
      behind.reach = surroundings / size;
      behind.may_cover = [&](const auto& part) {
        return isFreeOfOthers(part, map.free_labels, label);
      };
      for (const auto& ring : outlines[label]) {
        const auto corners = moveToWalls(simplifyOutline(ring, tolerance), behind);
        if (corners.empty())
          continue;
        room.area += size * size * ringArea(corners);
        std::vector<Eigen::Vector3d> line;
        for (const auto& corner : corners) {
          line.push_back(on_floor(corner.x(), corner.y()));
          line.back().z() = levels[room.label].floor;
        }
        room.footprint.push_back(line);
      }
      room.floor_seen = levels[room.label].floor_seen;
      room.ceiling_seen = levels[room.label].ceiling_seen;
      room.height = levels[room.label].ceiling - levels[room.label].floor;
      room.volume = room.area * room.height;
    }
  }
}

} // namespace pcl::indoor
