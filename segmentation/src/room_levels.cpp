/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "room_levels.h"

#include <pcl/segmentation/place_profile.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace indoor {
namespace {

double
heightOfLayer(const BuildingRooms& building, double layer)
{
  const VoxelGrid<std::uint8_t>& grid = building.occupancy.grid;
  return grid.origin.z() + grid.voxel_size * layer;
}

constexpr double crowd = 0.04; // metres: two standard deviations of a scanner's noise

/** What is seen of the ceiling in one column. */
struct ColumnTop {
  float lowest = std::numeric_limits<float>::infinity();
  std::int64_t sum = 0; ///< heights near the lowest point, micrometres: in any order
  std::int64_t count = 0;
};

/** Ceilings of the rooms, column by column of their free space. */
class Ceilings {
public:
  explicit Ceilings(const BuildingRooms& building)
  : building_(building)
  {
    for (const RoomMap& map : building.storeys)
      tops_.emplace_back(map.labels.size());
  }

  /** Look at a point of a room, all points for the first time ... */
  void
  findLowest(const Eigen::Vector3f& point, std::int32_t cell, const Room& room)
  {
    if (isCeiling(cell, room)) {
      ColumnTop& top = topOf(cell, room);
      top.lowest = std::min(top.lowest, point.z());
    }
  }

  /** ... and then for the second time: a thin slab is seen from above, too. */
  void
  add(const Eigen::Vector3f& point, std::int32_t cell, const Room& room)
  {
    if (!isCeiling(cell, room))
      return;
    ColumnTop& top = topOf(cell, room);
    if (point.z() - top.lowest > 2.0 * crowd)
      return;
    top.sum += std::llround(1e6 * static_cast<double>(point.z()));
    ++top.count;
  }

  /** Set the ceilings: the layers say how high they are on average, and the columns in
   * which points are seen how far they are from the middle of the layer. */
  void
  measure(std::vector<RoomLevels>& levels) const
  {
    std::vector<double> layers(levels.size(), 0.0), offset(levels.size(), 0.0);
    std::vector<std::size_t> columns(levels.size(), 0), seen(levels.size(), 0);
    for (std::size_t s = 0; s < building_.storeys.size(); ++s)
      for (std::size_t i = 0; i < tops_[s].size(); ++i) {
        const RoomMap& map = building_.storeys[s];
        const std::int32_t label = map.free_labels.values[i];
        if (label <= 0)
          continue;
        const std::uint32_t room = building_.room_of[s][label];
        const double middle =
            heightOfLayer(building_, map.first_layer + map.ceiling.values[i] + 0.5);
        layers[room] += middle;
        ++columns[room];
        if (tops_[s][i].count == 0)
          continue;
        offset[room] += 1e-6 * static_cast<double>(tops_[s][i].sum) /
                            static_cast<double>(tops_[s][i].count) -
                        middle;
        ++seen[room];
      }
    for (std::size_t k = 1; k < levels.size(); ++k)
      levels[k].ceiling = layers[k] / std::max<std::size_t>(columns[k], 1) +
                          offset[k] / std::max<std::size_t>(seen[k], 1);
  }

private:
  /** Whether a point is in free space of its room, above the slab that is free there.
   */
  bool
  isCeiling(std::int32_t cell, const Room& room) const
  {
    const RoomMap& map = building_.storeys[room.storey];
    const std::int32_t nz = building_.occupancy.grid.shape.nz;
    const std::int32_t pixel = cell / nz;
    const std::int32_t label = map.free_labels.values[pixel];
    const int below = map.ceiling.values[pixel] + map.first_layer - cell % nz;
    return label > 0 && building_.room_of[room.storey][label] == room.label &&
           below >= 0 && below < map.slab.first;
  }

  ColumnTop&
  topOf(std::int32_t cell, const Room& room)
  {
    return tops_[room.storey][cell / building_.occupancy.grid.shape.nz];
  }

  const BuildingRooms& building_;
  std::vector<std::vector<ColumnTop>> tops_; ///< per storey and pixel
};

} // namespace

std::vector<RoomLevels>
roomLevels(const std::vector<Eigen::Vector3f>& points, const BuildingRooms& building)
{
  const double size = building.occupancy.grid.voxel_size;
  std::vector<RoomLevels> levels(building.rooms.size() + 1);
  std::vector<PlaceProfile> floors(1, {0.0, 0.0, crowd});
  for (const Room& room : building.rooms) {
    const RoomMap& map = building.storeys[room.storey];
    // what is above the middle of the room is no floor
    levels[room.label].floor =
        heightOfLayer(building, map.first_layer + map.range.begin + 0.5);
    floors.emplace_back(room.point_count > 0 ? room.lower.z() - size : 0.0,
                        levels[room.label].floor + 0.5 * room.height,
                        crowd);
  }
  Ceilings ceilings(building);
  const auto eachPoint = [&](const auto& look) {
    for (std::size_t i = 0; i < points.size(); ++i)
      if (const std::uint32_t label = building.point_labels[i]; label > 0)
        look(points[i], building.occupancy.cells[i], building.rooms[label - 1]);
  };
  eachPoint([&](const auto& point, std::int32_t cell, const Room& room) {
    floors[room.label].add(point.z());
    ceilings.findLowest(point, cell, room);
  });
  eachPoint([&](const auto& point, std::int32_t cell, const Room& room) {
    ceilings.add(point, cell, room);
  });
  ceilings.measure(levels);
  for (std::size_t k = 1; k < levels.size(); ++k)
    levels[k].floor = floors[k].firstFace(1).value_or(levels[k].floor);
  return levels;
}

} // namespace indoor
} // namespace pcl
