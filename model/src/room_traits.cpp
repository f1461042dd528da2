/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "room_traits.h"

#include <pcl/indoor/disjoint_sets.h>
#include <pcl/indoor/quantile.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace pcl::indoor {

namespace {

// Building codes ask for windows of an eighth of a living room's floor area; half of
// that is enough here, since not all windows are found.
constexpr double least_light = 1.0 / 16.0;

/** Probability that at least one, and at least three, of independent objects are there.
 */
class SeenNumber {
public:
  void
  add(double probability)
  {
    for (std::size_t n = 3; n-- > 0;)
      numbers_[n] = numbers_[n] * (1.0 - probability) +
                    (n > 0 ? numbers_[n - 1] * probability : 0.0);
  }

  double
  atLeast(bool several) const
  {
    const double fewer =
        several ? numbers_[0] + numbers_[1] + numbers_[2] : numbers_[0];
    return std::clamp(1.0 - fewer, 0.0, 1.0);
  }

private:
  std::array<double, 3> numbers_{1.0, 0.0, 0.0}; ///< probability of 0, 1 and 2
};

bool
isKnownObject(const std::string& name)
{
  return std::any_of(std::begin(object_shares),
                     std::end(object_shares),
                     [&name](const auto& object) { return name == object.name; });
}

void
addObjects(const std::vector<RoomObject>& objects, RoomTraits& traits)
{
  constexpr double sure = 0.5;
  constexpr int fewest = 3;
  std::map<std::string, SeenNumber> seen;
  int known = 0;
  for (const auto& object : objects) {
    bool is_known = false;
    for (const auto& [name, probability] : object.classes) {
      const bool hangs = name == "cabinet" && object.foot > lowest_wall_cabinet;
      seen[hangs ? "wall cabinet" : name].add(probability);
      is_known = is_known || (probability >= sure && isKnownObject(name));
    }
    known += is_known ? 1 : 0;
  }
  traits.furnished = known >= fewest;
  for (std::size_t t = 0; t < object_count; ++t)
    if (const auto found = seen.find(object_shares[t].name); found != seen.end())
      traits.seen[t] = found->second.atLeast(object_shares[t].several);
}

/** Areas of floor and windows of each storey. */
struct StoreyLight {
  double floor = 0.0, windows = 0.0;
};

std::map<std::uint32_t, StoreyLight>
lightOfStoreys(const std::vector<RoomEvidence>& rooms)
{
  constexpr double most = 0.3; // of a floor: walls of glass say no more
  std::map<std::uint32_t, StoreyLight> storeys;
  for (const auto& room : rooms) {
    storeys[room.storey].floor += room.area;
    storeys[room.storey].windows += std::min(room.window_area, most * room.area);
  }
  return storeys;
}

bool
isLit(double windows, double floor)
{
  return floor > 0.0 && windows >= least_light * floor;
}

/** Light, and levels relative to the lowest storey with light: cellars have none. */
void
addStoreys(const std::vector<RoomEvidence>& rooms, BuildingTraits& building)
{
  const auto storeys = lightOfStoreys(rooms);
  const auto lit = std::find_if(storeys.begin(), storeys.end(), [](const auto& each) {
    return isLit(each.second.windows, each.second.floor);
  });
  const bool has_light = lit != storeys.end();
  const auto entrance = has_light ? lit->first : storeys.begin()->first;
  const auto level = [entrance](std::uint32_t storey) {
    return storey < entrance ? std::size_t(0) : storey == entrance ? 1u : 2u;
  };
  for (const auto& each : storeys)
    building.levels[level(each.first)] = true;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    auto& traits = building.rooms[r];
    traits.may_have_stairs = traits.tall || storeys.size() > 1;
    if (storeys.size() > 1)
      traits.level = level(rooms[r].storey);
    if (has_light && rooms[r].area > 0.0)
      traits.lit = isLit(rooms[r].window_area, rooms[r].area);
  }
}

/** Rooms that can be reached from each other: how many, and areas. */
struct Unit {
  std::size_t rooms = 0;
  double largest = 0.0, all = 0.0; // m^2

  void
  add(double area)
  {
    ++rooms;
    largest = std::max(largest, area);
    all += area;
  }
};

std::vector<std::uint32_t>
unitsOf(const std::vector<RoomEvidence>& rooms)
{
  DisjointSets sets(rooms.size());
  for (std::size_t r = 0; r < rooms.size(); ++r)
    for (const auto neighbour : rooms[r].neighbours)
      sets.merge(sets.find(static_cast<std::uint32_t>(r)),
                 sets.find(static_cast<std::uint32_t>(neighbour)));
  return sets.labels();
}

/** Geometric mean over the rooms of units of several; without any, that of storeys. */
std::optional<double>
floorArea(const std::vector<RoomEvidence>& rooms,
          const std::vector<std::uint32_t>& unit_of)
{
  constexpr std::size_t several = 3;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Unit> floors;
  std::map<std::uint32_t, Unit> storeys;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    floors[{unit_of[r], rooms[r].storey}].add(rooms[r].area);
    storeys[rooms[r].storey].add(rooms[r].area);
  }
  double sum = 0.0, count = 0.0;
  for (const auto& [place, floor] : floors)
    if (floor.rooms >= several && floor.all > 0.0) {
      sum += static_cast<double>(floor.rooms) * std::log(floor.all);
      count += static_cast<double>(floor.rooms);
    }
  if (count > 0.0)
    return std::exp(sum / count);
  for (const auto& [storey, floor] : storeys)
    sum += floor.all / static_cast<double>(storeys.size());
  return sum > 0.0 ? std::optional<double>(sum) : std::nullopt;
}

void
addUnits(const std::vector<RoomEvidence>& rooms, BuildingTraits& building)
{
  const auto unit_of = unitsOf(rooms);
  building.floor_area = floorArea(rooms, unit_of);
  std::map<std::uint32_t, Unit> units;
  for (std::size_t r = 0; r < rooms.size(); ++r)
    units[unit_of[r]].add(rooms[r].area);
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const auto& unit = units[unit_of[r]];
    if (unit.rooms >= rooms_of_home && unit.largest > 0.0)
      building.rooms[r].largest = rooms[r].area == unit.largest;
  }
}

double
middleHeight(const std::vector<RoomEvidence>& rooms)
{
  std::vector<double> heights;
  for (const auto& room : rooms)
    heights.push_back(room.height);
  return median(heights);
}

} // namespace

BuildingTraits
buildingTraits(const std::vector<RoomEvidence>& rooms)
{
  constexpr double much = 1.4; // times the height of most rooms
  BuildingTraits building;
  building.rooms.resize(rooms.size());
  if (rooms.empty())
    return building;
  const double height = middleHeight(rooms);
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const auto& room = rooms[r];
    auto& traits = building.rooms[r];
    if (room.area > 0.0)
      traits.area = room.area;
    if (room.area > 0.0 && room.perimeter > 0.0)
      traits.stretch = std::max(1.0, room.perimeter / (4.0 * std::sqrt(room.area)));
    std::set<std::size_t> others(room.neighbours.begin(), room.neighbours.end());
    others.erase(r);
    traits.ways = std::clamp<std::size_t>(others.size(), 1, 3) - 1;
    traits.tall = room.height > much * height;
    addObjects(room.objects, traits);
  }
  addStoreys(rooms, building);
  addUnits(rooms, building);
  return building;
}

} // namespace pcl::indoor
