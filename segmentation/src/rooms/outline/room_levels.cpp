/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/outline/room_levels.h"

#include "rooms/dimensions.h"
#include "rooms/outline/place_profile.h"

#include <pcl/indoor/quantile.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::indoor {
namespace {

double
heightOfLayer(const DetailedBuilding& building, double layer)
{
  const VoxelBits& grid = building.occupancy.grid;
  return grid.origin.z() + grid.voxel_size * layer;
}

/** What is seen of the ceiling in one column. */
struct ColumnTop {
  ColumnTop()
  : is_level(0)
  , count(0)
  {}

  float lowest = std::numeric_limits<float>::infinity();
  std::uint32_t is_level : 1; ///< whether the room's main ceiling is seen
  std::uint32_t count : 31;   ///< points near the lowest one
  std::int64_t sum = 0;       ///< of their heights, micrometres: in any order
};

/** Ceilings of the rooms of a storey, column by column of their free space. A thin slab
 * is seen from above, too, and objects hang from it: what counts is the lowest face
 * that many points of the room share, and elsewhere, as below a slope, what is lowest.
 */
class Ceilings {
public:
  Ceilings(const DetailedBuilding& building, std::size_t storey)
  : building_(building)
  , map_(building.room_maps[storey])
  , room_of_(building.room_of[storey])
  , place_of_(map_.free_labels.size(), 0)
  {
    const auto& labels = map_.free_labels.values;
    tops_.resize(labels.size() -
                 static_cast<std::size_t>(std::count(labels.begin(), labels.end(), 0)));
    std::uint32_t place = 0;
    for (std::size_t i = 0; i < labels.size(); ++i)
      if (labels[i] > 0)
        place_of_[i] = place++;
    for (const std::uint32_t label : room_of_)
      if (label > 0 && building.rooms[label - 1].point_count > 0) {
        const Room& room = building.rooms[label - 1];
        profiles_.emplace_back(room.lower.z(), room.upper.z() + crowd, crowd);
      }
      else
        profiles_.emplace_back(0.0, 0.0, crowd);
  }

  /** Look at a point of a room of this storey. */
  void
  add(std::size_t point, double height, std::int32_t cell, std::uint32_t room)
  {
    const std::int32_t nz = building_.occupancy.grid.shape.nz;
    const std::int32_t pixel = cell / nz;
    const int below = map_.belowCeiling(pixel, cell % nz);
    if (below < 0 || below >= map_.slab.first) // in the slab itself nothing is there
      return;
    const std::int32_t label = map_.free_labels.values[pixel];
    if (label <= 0 || room_of_[label] != room)
      return;
    ColumnTop& top = topOf(pixel);
    top.lowest = std::min(top.lowest, static_cast<float>(height));
    profiles_[label].add(height);
    seen_.push_back(static_cast<std::uint32_t>(point));
  }

  /** Set the ceilings: the layers say how high they are on average, and the columns in
   * which points are seen how far they are from the middle of the layer. */
  void
  measure(const std::vector<Eigen::Vector3f>& points, std::vector<RoomLevels>& levels)
  {
    std::vector<double> main;
    for (const PlaceProfile& profile : profiles_)
      main.push_back(profile.firstFace(1).value_or(0.0));
    addToColumns(points, main);
    std::vector<double> layers(main.size(), 0.0), offset(main.size(), 0.0);
    std::vector<std::size_t> columns(main.size(), 0), seen(main.size(), 0);
    for (std::size_t i = 0; i < place_of_.size(); ++i) {
      const std::int32_t label = map_.free_labels.values[i];
      if (label <= 0)
        continue;
      const double middle =
          heightOfLayer(building_, map_.first_layer + map_.ceiling.values[i] + 0.5);
      layers[label] += middle;
      ++columns[label];
      const ColumnTop& top = topOf(i);
      if (top.count == 0)
        continue;
      const double height =
          top.is_level ? main[label] : 1e-6 * static_cast<double>(top.sum) / top.count;
      offset[label] += height - middle;
      ++seen[label];
    }
    for (std::size_t label = 1; label < main.size(); ++label) {
      RoomLevels& level = levels[room_of_[label]];
      level.ceiling_seen =
          static_cast<double>(seen[label]) /
          static_cast<double>(std::max<std::size_t>(columns[label], 1));
      level.ceiling = layers[label] / std::max<std::size_t>(columns[label], 1) +
                      offset[label] / std::max<std::size_t>(seen[label], 1);
    }
  }

private:
  /** REQUIRES: the pixel is one of a room */
  ColumnTop&
  topOf(std::size_t pixel)
  {
    return tops_[place_of_[pixel]];
  }

  void
  addToColumns(const std::vector<Eigen::Vector3f>& points,
               const std::vector<double>& main)
  {
    for (const std::uint32_t i : seen_) {
      const std::int32_t pixel =
          building_.occupancy.cells[i] / building_.occupancy.grid.shape.nz;
      ColumnTop& top = topOf(pixel);
      const double height = points[i].z();
      if (std::abs(height - main[map_.free_labels.values[pixel]]) <= 0.5 * crowd)
        top.is_level = 1;
      if (height - top.lowest > 2.0 * crowd)
        continue;
      top.sum += std::llround(1e6 * height);
      ++top.count;
    }
  }

  const DetailedBuilding& building_;
  const RoomMap& map_;
  const std::vector<std::uint32_t>& room_of_; ///< of each label of the map
  std::vector<ColumnTop> tops_;               ///< of the columns of rooms, few of all
  std::vector<std::uint32_t> place_of_;       ///< there, per pixel
  std::vector<PlaceProfile> profiles_;        ///< per label of the map
  std::vector<std::uint32_t> seen_;           ///< points that were taken
};

/** Set how much of the floors was seen. */
void
measureFloors(const std::vector<Eigen::Vector3f>& points,
              const DetailedBuilding& building,
              std::vector<RoomLevels>& levels)
{
  const double size = building.occupancy.grid.voxel_size;
  std::vector<std::vector<std::uint8_t>> seen; // per storey and pixel
  for (const RoomMap& map : building.room_maps)
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
  for (std::size_t s = 0; s < building.room_maps.size(); ++s)
    for (std::size_t i = 0; i < seen[s].size(); ++i) {
      const std::uint32_t room =
          building.room_of[s][building.room_maps[s].free_labels.values[i]];
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
                const DetailedBuilding& building,
                std::vector<RoomLevels>& levels)
{
  const UnseenSides& unseen = building.interior.unseen;
  if (unseen.floorIsSeen() && unseen.ceilingIsSeen())
    return;
  std::vector<std::vector<float>> heights(levels.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    heights[building.point_labels[i]].push_back(points[i].z());
  constexpr double seen = 0.5; // share of the area
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
roomLevels(const std::vector<Eigen::Vector3f>& points, const DetailedBuilding& building)
{
  const double size = building.occupancy.grid.voxel_size;
  std::vector<RoomLevels> levels(building.rooms.size() + 1);
  std::vector<PlaceProfile> floors(1, {0.0, 0.0, crowd});
  for (const Room& room : building.rooms) {
    const RoomMap& map = building.room_maps[room.storey];
    // what is above the middle of the room is no floor
    levels[room.label].floor =
        heightOfLayer(building, map.first_layer + map.range.begin + 0.5);
    floors.emplace_back(room.point_count > 0 ? room.lower.z() - size : 0.0,
                        levels[room.label].floor + 0.5 * room.height,
                        crowd);
  }
  // Storey by storey, so that high buildings need no more memory than others.
  for (std::size_t s = 0; s < building.room_maps.size(); ++s) {
    Ceilings ceilings(building, s);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::uint32_t label = building.point_labels[i];
      if (label == 0 || building.rooms[label - 1].storey != s)
        continue;
      const double height = points[i].z();
      floors[label].add(height);
      ceilings.add(i, height, building.occupancy.cells[i], label);
    }
    ceilings.measure(points, levels);
  }
  for (std::size_t k = 1; k < levels.size(); ++k)
    levels[k].floor = floors[k].firstFace(1).value_or(levels[k].floor);
  measureFloors(points, building, levels);
  takeEndsOfWalls(points, building, levels);
  return levels;
}

} // namespace pcl::indoor
