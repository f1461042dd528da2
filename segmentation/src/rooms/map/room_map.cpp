/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/room_map.h"

#include "rooms/dimensions.h"
#include "rooms/map/ceiling_slab.h"
#include "rooms/map/continued_walls.h"
#include "rooms/map/inner_walls.h"
#include "rooms/map/open_plan.h"
#include "rooms/map/persistent_basins.h"
#include "rooms/map/region_borders.h"
#include "rooms/map/region_evidence.h"
#include "rooms/map/wall_lean.h"
#include "rooms/space/distance_map.h"
#include "rooms/space/nearest_sites.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace pcl::indoor {
namespace {

/** Columns with something in them, and the gaps between those (closing by a disc; there
 * is nothing beyond the map). */
PixelMap<std::uint8_t>
closed(const PixelMap<std::uint8_t>& held,
       double radius,
       double pixel_size,
       int threads)
{
  const double reach = std::pow(radius / pixel_size, 2);
  const int margin = static_cast<int>(radius / pixel_size) + 1;
  const auto beyond = [&](const PixelMap<std::uint8_t>& map) {
    PixelMap<std::uint8_t> far = map;
    const auto squared = squaredDistanceMap(map, threads);
    for (std::size_t i = 0; i < far.size(); ++i)
      far.values[i] = squared.values[i] > reach;
    return far;
  };
  auto wide =
      PixelMap<std::uint8_t>::filled(held.nx + 2 * margin, held.ny + 2 * margin, 0);
  for (int x = 0; x < held.nx; ++x)
    for (int y = 0; y < held.ny; ++y)
      wide.at(x + margin, y + margin) = held.at(x, y);
  wide = beyond(beyond(wide));
  PixelMap<std::uint8_t> result = held;
  for (int x = 0; x < held.nx; ++x)
    for (int y = 0; y < held.ny; ++y)
      result.at(x, y) = wide.at(x + margin, y + margin);
  return result;
}

/** The columns with walls, where these are seen best. */
PixelMap<std::uint8_t>
wallColumns(const StoreySpace& space,
            const RoomMap& map,
            const CeilingSlabOptions& options)
{
  const VoxelBits& occupancy = space.occupancy;
  const UnseenSides& unseen = space.interior.unseen;
  const auto blockedBelow = [&](const PixelMap<int>& tops) {
    return blockedColumns(
        occupancy, map.range, tops, slabLayers(occupancy, map.range, tops, options));
  };
  if (!unseen.ceilingIsSeen())
    return blockedBelow(seenTops(occupancy, map.range, map.ceiling, options));
  auto blocked = blockedColumns(occupancy, map.range, map.ceiling, map.slab);
  if (unseen.ceilingIsMostlySeen())
    return blocked;
  return continuedWalls(blocked,
                        blockedBelow(topsAtHeads(occupancy, map.range, map.ceiling)),
                        occupancy.voxel_size);
}

/** The columns that hold no more exterior free voxels than interior ones between the
 * floor and the ceiling; none where the storey is too low for rooms. */
PixelMap<std::uint8_t>
insideColumns(const StoreySpace& space, const PixelMap<int>& ceiling)
{
  const InteriorSpace& interior = space.interior;
  const int factor = interior.factor;
  const int offset = space.first_layer % factor; // the coarse layers may begin below
  auto inside = PixelMap<std::uint8_t>::filled(ceiling.nx, ceiling.ny, 0);
  if (occupiedHeight(space.occupancy) < standing_height)
    return inside;
  for (int x = 0; x < inside.nx; ++x)
    for (int y = 0; y < inside.ny; ++y) {
      const int end =
          std::min((ceiling.at(x, y) + offset) / factor, interior.inside.shape.nz);
      int surplus = 0;
      for (int z = (space.range.begin + offset) / factor; z < end; ++z)
        if (interior.inside.at(x / factor, y / factor, z))
          ++surplus;
        else if (!interior.occupancy.at(x / factor, y / factor, z))
          --surplus;
      inside.at(x, y) = ceiling.at(x, y) >= 0 && surplus >= 0;
    }
  return inside;
}

/** Distance of each pixel to the next obstacle, metres; 0 on it. */
PixelMap<float>
distanceTo(const PixelMap<std::uint8_t>& obstacles, double pixel_size, int threads)
{
  const PixelMap<std::uint32_t> squared = squaredDistanceMap(obstacles, threads);
  PixelMap<float> field{obstacles.nx, obstacles.ny, {}};
  field.values.resize(field.size());
  for (std::size_t i = 0; i < field.size(); ++i)
    field.values[i] =
        static_cast<float>(pixel_size * std::sqrt(double(squared.values[i])));
  return field;
}

/** Distance of each free pixel inside to the next blocked or outside one, metres. */
PixelMap<float>
freeDistance(const PixelMap<std::uint8_t>& blocked,
             const PixelMap<std::uint8_t>& inside,
             double pixel_size,
             int threads)
{
  PixelMap<std::uint8_t> obstacles = blocked;
  for (std::size_t i = 0; i < obstacles.size(); ++i)
    obstacles.values[i] |= !inside.values[i];
  return distanceTo(obstacles, pixel_size, threads);
}

/** Basins of the free pixels that a disc of the smallest room width can cover: gaps,
 * also those between the two faces of a wall, neither are rooms nor join them. */
PixelMap<std::int32_t>
basinsOfWidth(const PixelMap<float>& field,
              const BasinOptions& basins,
              double pixel_size,
              const RoomMapOptions& options)
{
  const double radius = 0.5 * options.min_width;
  PixelMap<float> centers = field;
  for (auto& distance : centers.values)
    if (distance < radius)
      distance = 0.0f;
  PixelMap<std::int32_t> labels = persistentBasins(centers, basins);
  growLabels(labels, radius / pixel_size);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (!(field.values[i] > 0))
      labels.values[i] = 0;
  return labels;
}

/** Remove labels of regions that are too small to be rooms. */
void
dropSmall(double pixel_size, double min_area, PixelMap<std::int32_t>& labels)
{
  std::vector<std::size_t> area(
      *std::max_element(labels.values.begin(), labels.values.end()) + 1, 0);
  for (const auto label : labels.values)
    ++area[label];
  const double pixel_area = pixel_size * pixel_size;
  for (auto& label : labels.values)
    if (static_cast<double>(area[label]) * pixel_area < min_area)
      label = 0;
}

/** Per label: the widest section through the region, twice its half width times its
 * height, m^2. */
std::vector<double>
sectionAreas(const PixelMap<std::int32_t>& labels,
             const PixelMap<float>& field,
             const RoomMap& map,
             double pixel_size)
{
  const std::int32_t count =
      *std::max_element(labels.values.begin(), labels.values.end());
  std::vector<double> section(count + 1, 0.0);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double height = pixel_size * (map.ceiling.values[i] - map.range.begin);
    double& widest = section[labels.values[i]];
    widest = std::max(widest, 2.0 * field.values[i] * height);
  }
  return section;
}

/** Carry the labels of free pixels into the walls. */
void
growIntoWalls(double reach_in_pixels, RoomMap& map)
{
  map.labels = map.free_labels;
  growLabels(map.labels, reach_in_pixels);
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

/** Labels none of which is merged. */
std::vector<std::int32_t>
asBefore(std::int32_t last)
{
  std::vector<std::int32_t> labels(last + 1);
  std::iota(labels.begin(), labels.end(), 0);
  return labels;
}

/** Join regions with an open border between them. */
void
joinOpenRegions(const VoxelBits& occupancy, const RoomMapOptions& options, RoomMap& map)
{
  const double size = occupancy.voxel_size;
  growIntoWalls(options.reach / size, map);
  const auto merged =
      mergeOpenRegions(regionBorders(borderMap(map, occupancy)),
                       sectionAreas(map.free_labels, map.field, map, size),
                       options.merging,
                       options.door_width);
  relabel(numbersOf(map.labels, merged), map);
}

/** Join niches to the rooms that they are part of. */
void
joinNiches(const VoxelBits& occupancy, RoomMap& map)
{
  const double size = occupancy.voxel_size;
  const auto count = static_cast<std::size_t>(map.room_count) + 1;
  std::vector<double> area(count, 0.0), volume(count, 0.0);
  for (std::size_t i = 0; i < map.free_labels.size(); ++i) {
    area[map.free_labels.values[i]] += size * size;
    volume[map.free_labels.values[i]] +=
        size * size * size * (map.ceiling.values[i] - map.range.begin);
  }
  const auto openings = regionOpenings(borderMap(map, occupancy));
  const auto merged = mergeNiches(openings, area, volume);
  if (merged != asBefore(map.room_count))
    relabel(numbersOf(map.labels, merged), map);
}

/** The pieces of the rooms that lie in different basins: a number per pixel, and the
 * room of each number. */
PixelMap<std::int32_t>
piecesOfRooms(const PixelMap<std::int32_t>& rooms,
              const PixelMap<std::int32_t>& basins,
              std::vector<std::int32_t>& room_of)
{
  auto pieces = PixelMap<std::int32_t>::filled(rooms.nx, rooms.ny, 0);
  room_of.assign(1, 0);
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> number;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::int32_t room = rooms.values[i], basin = basins.values[i];
    if (room == 0 || basin == 0)
      continue;
    const auto next = static_cast<std::int32_t>(room_of.size());
    const auto [place, is_new] = number.insert({{room, basin}, next});
    if (is_new)
      room_of.push_back(room);
    pieces.values[i] = place->second;
  }
  return pieces;
}

/** The new labels of the spaces of an open plan. The largest space of a room keeps its
 * label, and what is no space joins it.
 * \param[in] room_of,space_of of each piece
 * \param[in,out] last of the labels
 * \return per space, which has the number of one of its pieces; 0 = as before */
std::vector<std::int32_t>
newLabels(const OpenPlan& plan,
          const std::vector<std::int32_t>& room_of,
          const std::vector<std::int32_t>& space_of,
          std::int32_t& last)
{
  std::vector<std::vector<std::int32_t>> members(room_of.size());
  for (std::size_t piece = 1; piece < room_of.size(); ++piece)
    members[space_of[piece]].push_back(static_cast<std::int32_t>(piece));
  std::vector<std::int32_t> largest(last + 1, 0); // of each room
  for (std::size_t each = 1; each < members.size(); ++each) {
    std::int32_t& first = largest[room_of[each]];
    if (plan.area(members[each]) > plan.area(members[first]))
      first = static_cast<std::int32_t>(each);
  }
  std::vector<std::int32_t> label_of(members.size(), 0);
  for (std::size_t each = 1; each < members.size(); ++each)
    if (largest[room_of[each]] != static_cast<std::int32_t>(each) &&
        plan.isHabitable(members[each]))
      label_of[each] = ++last;
  return label_of;
}

/** Divide rooms that are two spaces of an open plan. */
void
divideOpenPlans(const StoreySpace& space,
                const RoomMapOptions& options,
                int threads,
                RoomMap& map)
{
  const double size = space.occupancy.voxel_size;
  const auto rooms = fillIslands(map.free_labels);
  PixelMap<std::uint8_t> walls{rooms.nx, rooms.ny, {}};
  for (const auto room : rooms.values)
    walls.values.push_back(room == 0);
  const auto field = distanceTo(walls, size, threads);
  std::vector<std::int32_t> room_of;
  const auto basins =
      basinsOfWidth(field, {options.open_plan.persistence}, size, options);
  const auto pieces = piecesOfRooms(rooms, basins, room_of);
  const OpenPlan plan(pieces, field, size, options.open_plan);
  PixelMap<std::int32_t> grown = pieces;
  growLabels(grown, options.reach / size);
  MergeOptions all;
  all.open_share = all.open_height = 0.0;
  const auto space_of = mergeOpenRegions(
      regionBorders(
          {space.occupancy, map.range, map.ceiling, grown, pieces, map.blocked}),
      sectionAreas(pieces, field, map, size),
      all,
      0.0,
      [&](const auto& a, const auto& b) {
        return room_of[a.front()] != room_of[b.front()] || plan.separates(a, b);
      });
  std::int32_t count = map.room_count;
  const auto label_of = newLabels(plan, room_of, space_of, count);
  if (count == map.room_count)
    return;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (const std::int32_t label = label_of[space_of[pieces.values[i]]];
        label != 0 && map.free_labels.values[i] != 0)
      map.free_labels.values[i] = label;
  map.room_count = count;
  growIntoWalls(options.reach / size, map);
}

} // namespace

RoomMap
mapWithoutRooms(const StoreySpace& space, const RoomMapOptions& options, int threads)
{
  const VoxelBits& occupancy = space.occupancy;
  const double size = occupancy.voxel_size;
  RoomMap map;
  map.first_layer = space.first_layer;
  map.range = space.range;
  map.ceiling = ceilingLayers(occupancy, map.range, options.slab);
  map.slab = slabLayers(occupancy, map.range, map.ceiling, options.slab);
  map.blocked = wallColumns(space, map, options.slab);
  removeSpecks(map.blocked, voxelsIn(options.slab.min_wall, size));
  auto inside = insideColumns(space, map.ceiling);
  map.lean = leanMap(
      wallStretches(occupancy, map, threads), map.blocked.nx, map.blocked.ny, size);
  if (!map.lean.values.empty()) {    // above a wall that leans, the slab may be outside
    constexpr double half_gap = 0.5; // metres, in the floors and ceilings that are seen
    const auto held = straightenedColumns(occupancy, map.lean, slabHeights(map));
    const auto covered = closed(held, half_gap, size, threads);
    for (std::size_t i = 0; i < inside.size(); ++i)
      inside.values[i] &= covered.values[i];
  }
  map.field = freeDistance(map.blocked, inside, size, threads);
  return map;
}

RoomMap
segmentRoomMap(const StoreySpace& space, const RoomMapOptions& options, int threads)
{
  const VoxelBits& occupancy = space.occupancy;
  const double size = occupancy.voxel_size;
  RoomMap map = mapWithoutRooms(space, options, threads);
  map.free_labels = basinsOfWidth(
      map.field,
      {options.persistence, 0.5 * options.door_width, options.merging.door_share},
      size,
      options);
  dropSmall(size, options.min_area, map.free_labels);
  map.room_count =
      *std::max_element(map.free_labels.values.begin(), map.free_labels.values.end());
  divideAtInnerWalls(map.free_labels,
                     map.room_count,
                     space.interior.directions,
                     voxelsIn(thickest_wall, size),
                     options.open_plan.min_wall_share,
                     options.open_plan.habitable_area / (size * size));
  joinOpenRegions(occupancy, options, map);
  divideOpenPlans(space, options, threads, map);
  joinNiches(occupancy, map);
  return map;
}

} // namespace pcl::indoor
