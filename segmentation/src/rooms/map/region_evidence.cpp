/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/region_evidence.h"

#include "rooms/map/region_borders.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace pcl::indoor {
namespace {

constexpr double enclosed = 0.8; // share of what bounds a room: most of four walls

/** The layer of the heads of people. */
int
headsIn(const VoxelBits& occupancy, const VerticalRange& range)
{
  constexpr double person = CeilingSlabOptions{}.min_height;
  const auto height = voxelsIn(person, occupancy.voxel_size);
  return std::min(range.begin + height, occupancy.shape.nz);
}

/** Whether something lies above the heads of people in a column. */
bool
isCovered(const VoxelBits& occupancy, int heads, std::size_t pixel)
{
  return occupancy.column(pixel).any(heads, occupancy.shape.nz);
}

/** How many columns without a room have something near the level of the floors, and
 * nothing above. */
std::size_t
groundColumns(const VoxelBits& occupancy, const RoomMap& map)
{
  constexpr double slope = 0.5; // metres
  const int reach = voxelsIn(slope, occupancy.voxel_size);
  const int heads = headsIn(occupancy, map.range);
  const int begin = std::max(map.range.begin - reach, 0);
  const int end = std::min(map.range.begin + reach, occupancy.shape.nz);
  std::size_t count = 0;
  for (std::size_t i = 0; i < map.free_labels.size(); ++i)
    count += map.free_labels.values[i] == 0 && !isCovered(occupancy, heads, i) &&
             occupancy.column(i).any(begin, end);
  return count;
}

/** What a share of the area exceeds, or is equal to; 0 without area. */
double
exceededBy(double share,
           const std::vector<double>& values,
           const std::vector<double>& area)
{
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return values[a] < values[b];
  });
  double left = (1.0 - share) * std::accumulate(area.begin(), area.end(), 0.0);
  double value = 0.0;
  for (std::size_t k = 0; k < order.size() && left > 0.0; ++k) {
    left -= area[order[k]];
    value = values[order[k]];
  }
  return value;
}

/** Sides of a region's pixels. */
struct RegionSides {
  std::size_t open = 0; ///< to what is neither wall nor room
  std::size_t all = 0;  ///< to other than itself
};

/** \param[in] reach pixels within which a wall or another region closes a side (> 0) */
std::vector<RegionSides>
sidesOf(const RoomMap& map, int reach)
{
  std::vector<RegionSides> sides(map.room_count + 1);
  const PixelMap<std::int32_t>& labels = map.free_labels;
  const auto isClosed = [&](int x, int y) {
    return map.blocked.at(x, y) != 0 || labels.at(x, y) != 0;
  };
  for (int x = 0; x < labels.nx; ++x)
    for (int y = 0; y < labels.ny; ++y) {
      const std::int32_t own = labels.at(x, y);
      if (own == 0)
        continue;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        int u = x + dx, v = y + dy;
        if (labels.contains(u, v) && labels.at(u, v) == own)
          continue;
        bool is_open = true;
        for (int k = 0; k < reach && is_open && labels.contains(u, v); ++k) {
          is_open = !isClosed(u, v);
          u += dx;
          v += dy;
        }
        ++sides[own].all;
        sides[own].open += is_open;
      }
    }
  return sides;
}

} // namespace

std::vector<LevelSides>
levelSides(const VoxelBits& occupancy, const RoomMap& map)
{
  std::vector<LevelSides> sides(map.room_count + 1);
  const auto isOccupied = [&](std::size_t pixel, int begin, int end) {
    return occupancy.column(pixel).any(std::max(begin, 0),
                                       std::min(end, occupancy.shape.nz));
  };
  for (std::size_t i = 0; i < map.free_labels.size(); ++i) {
    if (map.free_labels.values[i] == 0)
      continue;
    LevelSides& side = sides[map.free_labels.values[i]];
    const int floor = map.range.begin, ceiling = map.ceiling.values[i];
    side.floor += isOccupied(i, floor - 2, floor + 2);
    side.ceiling += isOccupied(i, ceiling - 1, ceiling + 2);
    ++side.all;
  }
  return sides;
}

void
relabel(const std::vector<std::int32_t>& number, RoomMap& map)
{
  for (auto* labels : {&map.free_labels, &map.labels})
    for (auto& label : labels->values)
      label = number[label];
  map.room_count = *std::max_element(number.begin(), number.end());
}

std::size_t
dropRegions(const std::vector<std::uint8_t>& is_dropped, RoomMap& map)
{
  const auto count =
      static_cast<std::size_t>(std::count(is_dropped.begin(), is_dropped.end(), 1));
  if (count == 0)
    return 0;
  std::vector<std::int32_t> number(is_dropped.size(), 0);
  std::int32_t last = 0;
  for (std::size_t label = 1; label < number.size(); ++label)
    if (!is_dropped[label])
      number[label] = ++last;
  relabel(number, map);
  return count;
}

double
occupiedHeight(const VoxelBits& occupancy)
{
  std::vector<std::size_t> counts(occupancy.shape.nz, 0); // per layer
  for (std::size_t pixel = 0; pixel < occupancy.columns(); ++pixel)
    occupancy.column(pixel).forEachSet(
        0, occupancy.shape.nz, [&](int z) { ++counts[z]; });
  const std::size_t all = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  if (all == 0)
    return 0.0;
  const std::size_t few = all / 1000;
  std::size_t low = 0, high = counts.size() - 1;
  for (std::size_t below = counts[low]; below <= few; below += counts[low])
    ++low;
  for (std::size_t above = counts[high]; above <= few; above += counts[high])
    --high;
  return occupancy.voxel_size * static_cast<double>(high - low + 1);
}

std::vector<double>
closedBorders(const RoomMap& map, double pixel_size)
{
  constexpr double nearby = 0.3; // metres: what is beside a wall may belong to nothing
  const int reach = voxelsIn(nearby, pixel_size, 1);
  std::vector<double> closed;
  for (const RegionSides& sides : sidesOf(map, reach))
    closed.push_back(static_cast<double>(sides.all - sides.open) /
                     static_cast<double>(std::max<std::size_t>(1, sides.all)));
  return closed;
}

void
dropStreets(const StoreySpace& space, RoomMap& map)
{
  constexpr double least_cover = 0.1; // share of the area
  constexpr double most_open = 0.1;   // share of the border: more than a gate
  constexpr double large = 50.0;      // m^2: ceilings of rooms may be hidden, too
  if (!space.interior.unseen.ceilingIsSeen())
    return;
  const double pixel_area = std::pow(space.occupancy.voxel_size, 2);
  const int heads = headsIn(space.occupancy, map.range);
  std::vector<std::size_t> area(map.room_count + 1, 0), covered = area;
  for (std::size_t i = 0; i < map.free_labels.size(); ++i)
    if (const std::int32_t label = map.free_labels.values[i]; label > 0) {
      ++area[label];
      covered[label] += isCovered(space.occupancy, heads, i);
    }
  const std::vector<RegionSides> sides = sidesOf(map, 1);
  std::vector<std::uint8_t> is_street(area.size(), 0);
  for (std::size_t label = 1; label < area.size(); ++label)
    is_street[label] =
        static_cast<double>(area[label]) * pixel_area >= large &&
        static_cast<double>(covered[label]) < least_cover * area[label] &&
        static_cast<double>(sides[label].open) > most_open * sides[label].all;
  dropRegions(is_street, map);
}

void
dropOutdoors(const StoreySpace& space, OpenGround& ground, RoomMap& map)
{
  const std::vector<double> walls = closedBorders(map, space.occupancy.voxel_size);
  const std::vector<LevelSides> levels = levelSides(space.occupancy, map);
  std::vector<double> ceilings, area; // of enclosed regions
  for (std::size_t label = 1; label < walls.size(); ++label)
    if (walls[label] >= enclosed) {
      ceilings.push_back(levels[label].ceilingShare());
      area.push_back(static_cast<double>(levels[label].all));
      ground.enclosed += levels[label].all;
    }
  ground.open += groundColumns(space.occupancy, map);
  ground.usual_ceiling =
      std::max(ground.usual_ceiling, exceededBy(0.5, ceilings, area));
  if (!space.interior.unseen.ceilingIsSeen() || ground.open <= ground.enclosed ||
      ground.usual_ceiling == 0.0)
    return;
  std::vector<std::uint8_t> is_outdoors(walls.size(), 0);
  for (std::size_t label = 1; label < walls.size(); ++label)
    is_outdoors[label] =
        walls[label] + levels[label].ceilingShare() / ground.usual_ceiling < enclosed;
  dropRegions(is_outdoors, map);
}

std::size_t
dropSeenThroughOpenings(const StoreySpace& space, RoomMap& map)
{
  constexpr double half_seen = 4.5; // m^2: a room of which half was seen has more
  const double pixel_area = std::pow(space.occupancy.voxel_size, 2);
  const std::vector<double> walls = closedBorders(map, space.occupancy.voxel_size);
  const std::vector<LevelSides> levels = levelSides(space.occupancy, map);
  std::size_t largest = 0; // stays, with what is half as large: scans have rooms
  for (const LevelSides& level : levels)
    largest = std::max(largest, level.all);
  const bool has_floors = space.interior.unseen.floorIsSeen();
  const bool has_ceilings = space.interior.unseen.ceilingIsSeen();
  std::vector<std::uint8_t> is_dropped(walls.size(), 0);
  for (std::size_t label = 1; label < walls.size(); ++label) {
    const LevelSides& level = levels[label];
    const auto level_seen =
        static_cast<double>(has_floors * level.floor + has_ceilings * level.ceiling);
    const double seen =
        (4.0 * walls[label] + level_seen / static_cast<double>(level.all)) /
        (4 + has_floors + has_ceilings);
    const double area = static_cast<double>(level.all) * pixel_area;
    is_dropped[label] = seen < enclosed && area * seen < half_seen * (1.0 - seen) &&
                        2 * level.all < largest;
  }
  return dropRegions(is_dropped, map);
}

std::size_t
dropHardlySeen(const StoreySpace& space,
               const PixelMap<std::uint32_t>& points,
               RoomMap& map)
{
  constexpr double hardly = 0.15; // of the points per area of half of the storey
  constexpr double little = 0.25; // the same, where one cannot go
  constexpr double seldom = 0.25; // of the columns with points of a quarter of it
  const auto count = static_cast<std::size_t>(map.room_count) + 1;
  std::vector<double> area(count, 0.0), density(count, 0.0), held(count, 0.0);
  for (std::size_t i = 0; i < map.labels.size(); ++i) {
    area[map.free_labels.values[i]] += 1.0;
    held[map.free_labels.values[i]] += points.values[i] > 0;
    density[map.labels.values[i]] += points.values[i];
  }
  area[0] = 0.0;
  for (std::size_t label = 1; label < count; ++label) {
    density[label] /= std::max(1.0, area[label]);
    held[label] /= std::max(1.0, area[label]);
  }
  const double usual = exceededBy(0.5, density, area);
  const double usually_held = exceededBy(0.25, held, area);
  std::vector<std::uint8_t> is_reached(count, 1); // by someone who can go on there
  const auto isSparse = [&](std::size_t label) {
    return area[label] > 0.0 && density[label] < little * usual;
  };
  for (std::size_t label = 1; label < count; ++label)
    is_reached[label] = !isSparse(label);
  if (std::find(is_reached.begin(), is_reached.end(), 0) != is_reached.end())
    for (const RegionOpening& opening :
         regionOpenings(borderMap(map, space.occupancy))) {
      is_reached[opening.a] |= !isSparse(opening.b);
      is_reached[opening.b] |= !isSparse(opening.a);
    }
  const bool is_looked_into =
      space.interior.unseen.floorIsSeen() || space.interior.unseen.ceilingIsSeen();
  std::vector<std::uint8_t> is_dropped(count, 0);
  for (std::size_t label = 1; label < count; ++label)
    is_dropped[label] =
        area[label] > 0.0 &&
        (density[label] < (is_reached[label] ? hardly : little) * usual ||
         (is_looked_into && held[label] < seldom * usually_held));
  return dropRegions(is_dropped, map);
}

} // namespace pcl::indoor
