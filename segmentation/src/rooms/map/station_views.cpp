/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/station_views.h"

#include "rooms/dimensions.h"
#include "rooms/map/region_evidence.h"
#include <pcl/indoor/disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace pcl::indoor {
namespace {

constexpr std::size_t most_sightings = 256; // of a region: a share to a few percent

Eigen::Array3i
voxelAt(const Eigen::Vector3d& place)
{
  return place.array().floor().cast<int>();
}

/** Middle of a voxel, in voxels. */
Eigen::Vector3d
middleOf(std::int32_t cell, const GridShape& shape)
{
  const int pixel = cell / shape.nz;
  return Eigen::Vector3d(
      pixel / shape.ny + 0.5, pixel % shape.ny + 0.5, cell % shape.nz + 0.5);
}

/** Whether a voxel of the map lies in interior free space. */
bool
isInside(const Eigen::Array3i& voxel, const InteriorSpace& interior)
{
  const int x = voxel.x() / interior.factor, y = voxel.y() / interior.factor,
            z = voxel.z() / interior.factor;
  return (voxel >= 0).all() && interior.inside.shape.contains(x, y, z) &&
         interior.inside.at(x, y, z);
}

/** The regions on both sides of each pixel of a wall, where they are two. */
PixelMap<RegionPair>
partitionsOf(const RoomMap& map, double pixel_size)
{
  const int reach = voxelsIn(thickest_wall, pixel_size, 1);
  const PixelMap<std::int32_t>& labels = map.free_labels;
  auto sides = PixelMap<RegionPair>::filled(labels.nx, labels.ny, {0, 0});
  const auto beside = [&](int x, int y, int dx, int dy) {
    for (int k = 1; k <= reach; ++k)
      if (!labels.contains(x + k * dx, y + k * dy))
        break;
      else if (const auto label = labels.at(x + k * dx, y + k * dy); label != 0)
        return label;
    return 0;
  };
  for (int x = 0; x < labels.nx; ++x)
    for (int y = 0; y < labels.ny; ++y) {
      if (labels.at(x, y) != 0)
        continue;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}}) {
        const std::int32_t a = beside(x, y, -dx, -dy), b = beside(x, y, dx, dy);
        if (a != 0 && b != 0 && a != b)
          sides.at(x, y) = {std::min(a, b), std::max(a, b)};
      }
    }
  return sides;
}

/** Make regions one, with what lies between them. */
void
joinRegions(const std::vector<RegionPair>& pairs,
            const PixelMap<RegionPair>& partitions,
            RoomMap& map)
{
  if (pairs.empty())
    return;
  DisjointSets sets(static_cast<std::size_t>(map.room_count) + 1);
  for (const auto& [a, b] : pairs)
    sets.merge(sets.find(a), sets.find(b));
  const std::vector<std::uint32_t> numbers = sets.labels(); // 0 stays alone
  std::vector<std::int32_t> number(numbers.begin(), numbers.end());
  relabel(number, map);
  for (std::size_t i = 0; i < partitions.size(); ++i)
    if (std::binary_search(pairs.begin(), pairs.end(), partitions.values[i])) {
      map.free_labels.values[i] = map.labels.values[i] =
          number[partitions.values[i].first];
      map.blocked.values[i] = 0;
    }
}

} // namespace

StationViews::StationViews(const ScanStations& stations,
                           const OccupancyGrid& building,
                           const InteriorSpace& interior,
                           const Storeys& storeys)
: stations_(stations)
, building_(building)
, storeys_(storeys)
{
  for (const Eigen::Vector3d& position : stations.positions)
    place(position, interior);
  const auto& all = stations.positions;
  is_known_ &= std::all_of(all.begin(), all.end(), [](const Eigen::Vector3d& position) {
    return position.allFinite();
  });
}

void
StationViews::place(const Eigen::Vector3d& position, const InteriorSpace& interior)
{
  constexpr double apart = 1.0;    // metres: a carried scanner is at a thousand places
  constexpr double farthest = 1e6; // voxels
  const VoxelBits& grid = building_.grid;
  PlacedStation& station = placed_.emplace_back();
  station.position = position;
  const Eigen::Vector3d place = (building_.toGrid(position) - grid.origin);
  places_.emplace_back(place / grid.voxel_size);
  if (!(places_.back().array().abs() < farthest).all()) {
    places_.back().setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  const Eigen::Array3i voxel = voxelAt(places_.back());
  if (grid.shape.contains(voxel.x(), voxel.y(), 0))
    station.storey =
        storeys_.storeyAt(voxel.x(), voxel.y(), place.z() + grid.origin.z());
  is_known_ |= isInside(voxel, interior);
  const Eigen::Array3i cell = voxelAt(place / apart);
  if (taken_.insert({cell.x(), cell.y(), cell.z()}).second)
    apart_.push_back(static_cast<std::uint32_t>(placed_.size()));
}

bool
StationViews::empty() const
{
  return !is_known_;
}

bool
StationViews::isSlabBelow(std::int32_t cell, std::size_t storey) const
{
  if (storey == 0)
    return false;
  const VoxelBits& grid = building_.grid;
  const double height = grid.origin.z() + grid.voxel_size * (cell % grid.shape.nz);
  return height <
         storeys_.borders[storey - 1].values[cell / grid.shape.nz] + thickest_wall;
}

bool
StationViews::isUpright(std::int32_t cell, const RoomMap& map) const
{
  // nearer to floor or ceiling it may be these
  const GridShape& shape = building_.grid.shape;
  const int apart = voxelsIn(sill_height, building_.grid.voxel_size);
  const int z = cell % shape.nz - map.first_layer;
  return z >= map.range.begin + apart &&
         z < map.ceiling.values[cell / shape.nz] - apart;
}

std::uint32_t
StationViews::stationOf(std::size_t point) const
{
  if (stations_.of_point.empty())
    return 0;
  const std::uint32_t station = stations_.of_point[point];
  const bool is_known =
      station > 0 && station <= places_.size() && places_[station - 1].allFinite();
  return is_known ? station : 0;
}

std::vector<std::int32_t>
StationViews::regionsOf(const RoomMap& map, std::size_t storey) const
{
  std::vector<std::int32_t> regions(placed_.size(), 0);
  for (std::size_t k = 0; k < placed_.size(); ++k) {
    if (placed_[k].storey != static_cast<int>(storey))
      continue;
    const Eigen::Array3i voxel = voxelAt(places_[k]);
    regions[k] = map.labels.at(voxel.x(), voxel.y());
  }
  return regions;
}

bool
StationViews::isClosed(const Eigen::Array3i& voxel, const RoomMap& map) const
{
  const VoxelBits& grid = building_.grid;
  const auto column = grid.column(voxel.x(), voxel.y());
  const int floor = map.first_layer + map.range.begin;
  const int ceiling = map.first_layer + map.range.end;
  if (voxel.z() < floor || voxel.z() >= ceiling)
    return column[voxel.z()];
  if (map.free_labels.at(voxel.x(), voxel.y()) != 0)
    return false; // objects do not close a room
  const auto layers = [&](double height) { return voxelsIn(height, grid.voxel_size); };
  return column[voxel.z()] ||
         column.any(std::min(floor + layers(sill_height), grid.shape.nz),
                    std::min(floor + layers(passage_height), grid.shape.nz));
}

bool
StationViews::isFreeWay(std::uint32_t station,
                        const Eigen::Vector3d& to,
                        const RoomMap& map,
                        std::size_t storey) const
{
  constexpr double step = 0.5;  // voxels
  constexpr double level = 0.3; // metres from the end, where its own surface goes on
  const VoxelBits& grid = building_.grid;
  const bool through_slab = placed_[station - 1].storey != static_cast<int>(storey);
  const Eigen::Vector3d way = places_[station - 1] - to;
  const double length = way.norm();
  Eigen::Array3i last = voxelAt(to);
  for (double k = step; k < length; k += step) {
    const Eigen::Array3i voxel = voxelAt(to + way * (k / length));
    if ((voxel == last).all() || !grid.shape.contains(voxel.x(), voxel.y(), voxel.z()))
      continue;
    last = voxel;
    if (isClosed(voxel, map) || (through_slab && k * grid.voxel_size > level &&
                                 grid.at(voxel.x(), voxel.y(), voxel.z())))
      return false;
  }
  return true;
}

bool
StationViews::isSeen(const Sighting& sighting,
                     const RoomMap& map,
                     std::size_t storey) const
{
  constexpr std::size_t most = 32; // stations: farther ones see less
  const Eigen::Vector3d place = middleOf(sighting.cell, building_.grid.shape);
  if (sighting.station > 0)
    return isFreeWay(sighting.station, place, map, storey);
  std::vector<std::pair<double, std::uint32_t>> nearest;
  for (const std::uint32_t station : apart_)
    nearest.emplace_back((places_[station - 1] - place).squaredNorm(), station);
  const auto count = static_cast<std::ptrdiff_t>(std::min(most, nearest.size()));
  std::partial_sort(nearest.begin(), nearest.begin() + count, nearest.end());
  return std::any_of(nearest.begin(), nearest.begin() + count, [&](const auto& near) {
    return isFreeWay(near.second, place, map, storey);
  });
}

std::vector<std::vector<StationViews::Sighting>>
StationViews::sightings(const StoreyPoints& points,
                        const RoomMap& map,
                        const std::vector<std::uint8_t>& is_asked) const
{
  std::vector<std::vector<Sighting>> seen(is_asked.size());
  const int nz = building_.grid.shape.nz;
  for (std::size_t i = 0; i < points.storey_of.size(); ++i) {
    const std::int32_t cell = building_.cells[i];
    if (cell < 0 || points.storey_of[i] != points.storey)
      continue;
    const std::int32_t label = map.free_labels.values[cell / nz];
    if (is_asked[label] && !isSlabBelow(cell, points.storey))
      seen[label].push_back({cell, stationOf(i)});
  }
  for (auto& all : seen) {
    // in an order that is not that of the points
    std::sort(all.begin(), all.end(), [](const Sighting& a, const Sighting& b) {
      return std::tie(a.cell, a.station) < std::tie(b.cell, b.station);
    });
    all.erase(std::unique(all.begin(),
                          all.end(),
                          [](const Sighting& a, const Sighting& b) {
                            return a.cell == b.cell && a.station == b.station;
                          }),
              all.end());
    const std::size_t count = std::min(most_sightings, all.size());
    for (std::size_t k = 0; k < count; ++k)
      all[k] = all[k * all.size() / count];
    all.resize(count);
  }
  return seen;
}

double
StationViews::shareSeen(const std::vector<Sighting>& sightings,
                        const RoomMap& map,
                        std::size_t storey) const
{
  const auto seen =
      std::count_if(sightings.begin(), sightings.end(), [&](const auto& sighting) {
        return isSeen(sighting, map, storey);
      });
  return static_cast<double>(seen) /
         static_cast<double>(std::max<std::size_t>(1, sightings.size()));
}

std::size_t
StationViews::dropNeverEntered(const StoreyPoints& points, RoomMap& map) const
{
  constexpr double hardly = 0.25; // of its voxels
  if (empty())
    return 0;
  std::vector<std::uint8_t> is_asked(map.room_count + 1, 1);
  is_asked[0] = 0;
  for (const std::int32_t region : regionsOf(map, points.storey))
    is_asked[region] = 0;
  if (std::find(is_asked.begin(), is_asked.end(), 1) == is_asked.end())
    return 0;
  std::vector<std::uint8_t> is_dropped(is_asked.size(), 0);
  const auto seen = sightings(points, map, is_asked);
  for (std::size_t label = 1; label < is_asked.size(); ++label)
    is_dropped[label] =
        is_asked[label] && shareSeen(seen[label], map, points.storey) < hardly;
  return dropRegions(is_dropped, map);
}

std::map<RegionPair, PartitionPoints>
StationViews::countPartitions(const StoreyPoints& points,
                              const RoomMap& map,
                              const PixelMap<RegionPair>& partitions) const
{
  const std::vector<std::int32_t> region_of = regionsOf(map, points.storey);
  std::vector<std::uint8_t> is_entered(map.room_count + 1, 0);
  for (const std::int32_t region : region_of)
    is_entered[region] = region > 0;
  std::map<RegionPair, PartitionPoints> counts;
  for (std::size_t i = 0; i < points.storey_of.size(); ++i) {
    const std::int32_t cell = building_.cells[i];
    if (cell < 0 || points.storey_of[i] != points.storey)
      continue;
    const RegionPair& sides = partitions.values[cell / building_.grid.shape.nz];
    const std::uint32_t station = stationOf(i);
    if (!is_entered[sides.first] || !is_entered[sides.second] || station == 0 ||
        !isUpright(cell, map))
      continue;
    PartitionPoints& count = counts[sides];
    const std::int32_t region = region_of[station - 1];
    ++count.all;
    count.own += region == sides.first || region == sides.second;
  }
  for (const RegionPair& sides : partitions.values)
    if (const auto count = counts.find(sides); count != counts.end())
      ++count->second.pixels;
  return counts;
}

std::size_t
StationViews::joinMirrored(const StoreyPoints& points, RoomMap& map) const
{
  constexpr double most_own = 0.1; // share of a partition's points
  constexpr double least = 0.1;    // m^2 of it from above: smaller ones are corners
  if (empty() || stations_.of_point.empty())
    return 0;
  const double pixel_area = std::pow(building_.grid.voxel_size, 2);
  const auto partitions = partitionsOf(map, building_.grid.voxel_size);
  std::vector<RegionPair> mirrored;
  for (const auto& [sides, count] : countPartitions(points, map, partitions)) {
    if (static_cast<double>(count.own) < most_own * static_cast<double>(count.all) &&
        static_cast<double>(count.pixels) * pixel_area >= least)
      mirrored.push_back(sides);
  }
  joinRegions(mirrored, partitions, map);
  return mirrored.size();
}

} // namespace pcl::indoor
