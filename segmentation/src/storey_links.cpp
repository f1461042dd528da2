/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/storey_links.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl {
namespace indoor {
namespace {

constexpr double slab_reach = 0.5; // metres above and below a boundary between storeys

/** Whether a column is open from one storey to the next. */
bool
isOpenBetween(const VoxelGrid<std::uint8_t>& occupancy,
              const RoomMap& lower,
              const RoomMap& upper,
              std::size_t pixel)
{
  const int reach = static_cast<int>(std::lround(slab_reach / occupancy.voxel_size));
  const auto* column = &occupancy.values[pixel * occupancy.shape.nz];
  const int begin = std::max(lower.storey.begin, lower.storey.end - reach);
  const int end = std::min(upper.storey.end, upper.storey.begin + reach);
  return std::none_of(column + begin, column + end, [](auto value) { return value; });
}

/** Per region of the upper map the region of the lower one that it is open to, or 0. */
std::vector<std::int32_t>
regionsBelow(const VoxelGrid<std::uint8_t>& occupancy,
             const RoomMap& lower,
             const RoomMap& upper,
             double open_share)
{
  std::vector<std::size_t> area(upper.room_count + 1, 0);
  std::vector<std::map<std::int32_t, std::size_t>> open(upper.room_count + 1);
  for (std::size_t i = 0; i < upper.free_labels.size(); ++i) {
    const std::int32_t label = upper.free_labels.values[i];
    const std::int32_t below = lower.free_labels.values[i];
    ++area[label];
    if (label > 0 && below > 0 && isOpenBetween(occupancy, lower, upper, i))
      ++open[label][below];
  }
  std::vector<std::int32_t> result(upper.room_count + 1, 0);
  for (std::int32_t label = 1; label <= upper.room_count; ++label)
    for (const auto& [below, count] : open[label])
      if (count > open_share * area[label])
        result[label] = below;
  return result;
}

} // namespace

std::vector<std::vector<std::uint32_t>>
numberRooms(const VoxelGrid<std::uint8_t>& occupancy,
            const std::vector<RoomMap>& maps,
            double open_share)
{
  std::vector<std::vector<std::uint32_t>> rooms(maps.size());
  std::uint32_t count = 0;
  for (std::size_t s = 0; s < maps.size(); ++s) {
    rooms[s].assign(maps[s].room_count + 1, 0);
    std::vector<std::int32_t> below(maps[s].room_count + 1, 0);
    if (s > 0)
      below = regionsBelow(occupancy, maps[s - 1], maps[s], open_share);
    for (std::int32_t label = 1; label <= maps[s].room_count; ++label)
      rooms[s][label] = below[label] > 0 ? rooms[s - 1][below[label]] : ++count;
  }
  return rooms;
}

} // namespace indoor
} // namespace pcl
