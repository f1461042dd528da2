/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/outline/room_levels.h"

#include "rooms/outline/place_profile.h"

#include <pcl/indoor/quantile.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace indoor {
namespace {

double
heightOfLayer(const BuildingRooms& building, double layer)
{
  const VoxelBits& grid = building.occupancy.grid;
  return grid.origin.z() + grid.voxel_size * layer;
}

/** What is seen of the ceiling in one column. */
struct ColumnTop {
  float lowest = std::numeric_limits<float>::infinity();
  bool is_level = false; ///< whether the room's main ceiling is seen
  std::int32_t count = 0;
  std::int64_t sum = 0; ///< heights near the lowest point, micrometres: in any order
};

/** Ceilings of the rooms, column by column of their free space. A thin slab is seen
 * from above, too, and things hang from it: what counts is the lowest face that many
 * points of the room share, and elsewhere, as below a slope, what is lowest. */
class Ceilings {
public:
  explicit Ceilings(const BuildingRooms& building)
  : building_(building)
  {
    for (const RoomMap& map : building.maps) {
      auto& places = place_of_.emplace_back(map.free_labels.size(), 0);
      for (std::size_t i = 0; i < places.size(); ++i)
        if (map.free_labels.values[i] > 0) {
          places[i] = static_cast<std::uint32_t>(tops_.size());
          tops_.emplace_back();
        }
    }
    profiles_.emplace_back(0.0, 0.0, crowd);
    for (const Room& room : building.rooms)
      profiles_.emplace_back(room.point_count > 0 ? room.lower.z() : 0.0,
                             room.point_count > 0 ? room.upper.z() + crowd : 0.0,
                             crowd);
  }

  /** Look at a point of a room. */
  void
  add(std::size_t point, double height, std::int32_t cell, const Room& room)
  {
    const RoomMap& map = building_.maps[room.storey];
    const std::int32_t nz = building_.occupancy.grid.shape.nz;
    const std::int32_t pixel = cell / nz;
    const int below = map.ceiling.values[pixel] + map.first_layer - cell % nz;
    if (below < 0 || below >= map.slab.first) // in the slab itself nothing is there
      return;
    const std::int32_t label = map.free_labels.values[pixel];
    if (label <= 0 || building_.room_of[room.storey][label] != room.label)
      return;
    ColumnTop& top = topOf(room.storey, pixel);
    top.lowest = std::min(top.lowest, static_cast<float>(height));
    profiles_[room.label].add(height);
    seen_.push_back(point);
  }

  /** Set the ceilings: the layers say how high they are on average, and the columns in
   * which points are seen how far they are from the middle of the layer. */
  void
  measure(const std::vector<Eigen::Vector3f>& points, std::vector<RoomLevels>& levels)
  {
    std::vector<double> main(levels.size(), 0.0);
    for (std::size_t k = 1; k < levels.size(); ++k)
      main[k] = profiles_[k].firstFace(1).value_or(0.0);
    addToColumns(points, main);
    std::vector<double> layers(levels.size(), 0.0), offset(levels.size(), 0.0);
    std::vector<std::size_t> columns(levels.size(), 0), seen(levels.size(), 0);
    for (std::size_t s = 0; s < building_.maps.size(); ++s)
      for (std::size_t i = 0; i < place_of_[s].size(); ++i) {
        const RoomMap& map = building_.maps[s];
        const std::int32_t label = map.free_labels.values[i];
        if (label <= 0)
          continue;
        const std::uint32_t room = building_.room_of[s][label];
        const double middle =
            heightOfLayer(building_, map.first_layer + map.ceiling.values[i] + 0.5);
        layers[room] += middle;
        ++columns[room];
        const ColumnTop& top = topOf(s, i);
        if (top.count == 0)
          continue;
        const double height =
            top.is_level ? main[room] : 1e-6 * static_cast<double>(top.sum) / top.count;
        offset[room] += height - middle;
        ++seen[room];
      }
    for (std::size_t k = 1; k < levels.size(); ++k)
      levels[k].ceiling_seen =
          static_cast<double>(seen[k]) /
          static_cast<double>(std::max<std::size_t>(columns[k], 1));
    for (std::size_t k = 1; k < levels.size(); ++k)
      levels[k].ceiling = layers[k] / std::max<std::size_t>(columns[k], 1) +
                          offset[k] / std::max<std::size_t>(seen[k], 1);
  }

private:
  /** REQUIRES: the pixel is one of a room */
  ColumnTop&
  topOf(std::size_t storey, std::size_t pixel)
  {
    return tops_[place_of_[storey][pixel]];
  }

  void
  addToColumns(const std::vector<Eigen::Vector3f>& points,
               const std::vector<double>& main)
  {
    for (const std::size_t i : seen_) {
      const Room& room = building_.rooms[building_.point_labels[i] - 1];
      const std::int32_t cell = building_.occupancy.cells[i];
      ColumnTop& top = topOf(room.storey, cell / building_.occupancy.grid.shape.nz);
      const double height = points[i].z();
      top.is_level |= std::abs(height - main[room.label]) <= 0.5 * crowd;
      if (height - top.lowest > 2.0 * crowd)
        continue;
      top.sum += std::llround(1e6 * height);
      ++top.count;
    }
  }

  const BuildingRooms& building_;
  std::vector<ColumnTop> tops_; ///< of the columns of rooms, few of all
  std::vector<std::vector<std::uint32_t>> place_of_; ///< there, per storey and pixel
  std::vector<PlaceProfile> profiles_;               ///< per label of a room
  std::vector<std::size_t> seen_;                    ///< points that were taken
};

/** Set how much of the floors was seen. */
void
measureFloors(const std::vector<Eigen::Vector3f>& points,
              const BuildingRooms& building,
              std::vector<RoomLevels>& levels)
{
  const double size = building.occupancy.grid.voxel_size;
  std::vector<std::vector<std::uint8_t>> seen; // per storey and pixel
  for (const RoomMap& map : building.maps)
    seen.emplace_back(map.labels.size(), 0);
  std::vector<double> floors;
  for (const auto& level : levels)
    floors.push_back(level.floor);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const std::uint32_t label = building.point_labels[i];
        label > 0 && std::abs(points[i].z() - floors[label]) <= size)
      seen[building.rooms[label - 1].storey]
          [building.occupancy.cells[i] / building.occupancy.grid.shape.nz] = 1;
  std::vector<std::size_t> columns(levels.size(), 0), with_floor = columns;
  for (std::size_t s = 0; s < building.maps.size(); ++s)
    for (std::size_t i = 0; i < seen[s].size(); ++i) {
      const std::uint32_t room =
          building.room_of[s][building.maps[s].free_labels.values[i]];
      ++columns[room];
      with_floor[room] += seen[s][i];
    }
  for (std::size_t k = 1; k < levels.size(); ++k)
    levels[k].floor_seen = static_cast<double>(with_floor[k]) /
                           static_cast<double>(std::max<std::size_t>(columns[k], 1));
}

/** Where floors or ceilings are missing, rooms go as far as their points do, without
 * the outermost hundredths. */
void
takeEndsOfWalls(const std::vector<Eigen::Vector3f>& points,
                const BuildingRooms& building,
                std::vector<RoomLevels>& levels)
{
  const UnseenSides& unseen = building.interior.unseen;
  if (unseen.floorIsSeen() && unseen.ceilingIsSeen())
    return;
  std::vector<std::vector<float>> heights(levels.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    heights[building.point_labels[i]].push_back(points[i].z());
  constexpr double seen = 0.5; // share of the area, as for the whole building
  for (std::size_t k = 1; k < levels.size(); ++k) {
    if (heights[k].empty())
      continue;
    const std::size_t last = heights[k].size() - 1, few = heights[k].size() / 100;
    if (!unseen.floorIsSeen() && levels[k].floor_seen < seen) {
      levels[k].floor = valueAtRank(heights[k], few);
      levels[k].floor_seen = 0.0;
    }
    if (!unseen.ceilingIsSeen() && levels[k].ceiling_seen < seen) {
      levels[k].ceiling = valueAtRank(heights[k], last - few);
      levels[k].ceiling_seen = 0.0;
    }
  }
}

} // namespace

std::vector<RoomLevels>
roomLevels(const std::vector<Eigen::Vector3f>& points, const BuildingRooms& building)
{
  const double size = building.occupancy.grid.voxel_size;
  std::vector<RoomLevels> levels(building.rooms.size() + 1);
  std::vector<PlaceProfile> floors(1, {0.0, 0.0, crowd});
  for (const Room& room : building.rooms) {
    const RoomMap& map = building.maps[room.storey];
    // what is above the middle of the room is no floor
    levels[room.label].floor =
        heightOfLayer(building, map.first_layer + map.range.begin + 0.5);
    floors.emplace_back(room.point_count > 0 ? room.lower.z() - size : 0.0,
                        levels[room.label].floor + 0.5 * room.height,
                        crowd);
  }
  Ceilings ceilings(building);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const std::uint32_t label = building.point_labels[i]; label > 0) {
      const double height = points[i].z();
      floors[label].add(height);
      ceilings.add(i, height, building.occupancy.cells[i], building.rooms[label - 1]);
    }
  ceilings.measure(points, levels);
  for (std::size_t k = 1; k < levels.size(); ++k)
    levels[k].floor = floors[k].firstFace(1).value_or(levels[k].floor);
  measureFloors(points, building, levels);
  takeEndsOfWalls(points, building, levels);
  return levels;
}

} // namespace indoor
} // namespace pcl
