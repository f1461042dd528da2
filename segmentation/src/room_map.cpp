/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/nearest_sites.h>
#include <pcl/segmentation/persistent_basins.h>
#include <pcl/segmentation/potential_field.h>
#include <pcl/segmentation/room_map.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl {
namespace indoor {
namespace {

/** Distance of each free pixel inside to the next blocked or outside one, metres. */
PixelMap<float>
freeDistance(const PixelMap<std::uint8_t>& blocked,
             const PixelMap<std::uint8_t>& inside,
             double pixel_size)
{
  PixelMap<std::uint8_t> obstacle = blocked;
  for (std::size_t i = 0; i < obstacle.size(); ++i)
    obstacle.values[i] |= !inside.values[i];
  const PixelMap<std::uint32_t> squared = squaredDistanceMap(obstacle);
  PixelMap<float> field{blocked.nx, blocked.ny, {}};
  field.values.resize(field.size());
  for (std::size_t i = 0; i < field.size(); ++i)
    field.values[i] = static_cast<float>(
        obstacle.values[i] ? 0.0 : pixel_size * std::sqrt(double(squared.values[i])));
  return field;
}

/** Remove labels of regions that are too narrow or too small for a room. */
void
dropSmallRegions(PixelMap<std::int32_t>& labels,
                 const PixelMap<float>& field,
                 double pixel_size,
                 const RoomMapOptions& options)
{
  const std::int32_t count =
      *std::max_element(labels.values.begin(), labels.values.end());
  std::vector<std::size_t> area(count + 1, 0);
  std::vector<float> half_width(count + 1, 0.0f);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::int32_t label = labels.values[i];
    ++area[label];
    half_width[label] = std::max(half_width[label], field.values[i]);
  }
  for (auto& label : labels.values)
    if (label != 0 && (area[label] * pixel_size * pixel_size < options.min_area ||
                       2.0f * half_width[label] < options.min_width))
      label = 0;
}

/** New numbers 1 ... n for merged labels, in the order of their first pixel. */
std::vector<std::int32_t>
numbersOf(const PixelMap<std::int32_t>& labels, const std::vector<std::int32_t>& merged)
{
  std::vector<std::int32_t> number(merged.size(), 0);
  std::int32_t count = 0;
  for (const auto label : labels.values)
    if (label != 0 && number[merged[label]] == 0)
      number[merged[label]] = ++count;
  for (std::size_t i = 0; i < merged.size(); ++i)
    number[i] = number[merged[i]];
  return number;
}

} // namespace

RoomMap
segmentRoomMap(const VoxelGrid<std::uint8_t>& occupancy,
               const VerticalRange& storey,
               const PixelMap<std::uint8_t>& inside,
               const RoomMapOptions& options)
{
  const double size = occupancy.voxel_size;
  RoomMap map;
  map.storey = storey;
  map.ceiling = ceilingLayers(occupancy, storey, options.slab);
  map.blocked = blockedBelowCeiling(occupancy, storey, map.ceiling, options.slab);
  map.field = freeDistance(map.blocked, inside, size);
  map.free_labels =
      persistentBasins(map.field, static_cast<float>(options.persistence));
  dropSmallRegions(map.free_labels, map.field, size, options);

  map.labels = map.free_labels;
  growLabels(map.labels, options.reach / size);
  const std::int32_t basins =
      *std::max_element(map.labels.values.begin(), map.labels.values.end());
  const auto borders =
      regionBorders(occupancy, storey, map.ceiling, map.labels, map.free_labels);
  const auto merged = mergeOpenRegions(borders, basins, options.open_share);
  const auto number = numbersOf(map.labels, merged);
  for (auto& label : map.free_labels.values)
    label = number[label];
  for (auto& label : map.labels.values)
    label = number[label];
  map.room_count = *std::max_element(number.begin(), number.end());
  map.borders =
      regionBorders(occupancy, storey, map.ceiling, map.labels, map.free_labels);
  return map;
}

} // namespace indoor
} // namespace pcl
