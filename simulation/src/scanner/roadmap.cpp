/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scanner/roadmap.h"

#include "scanner/free_places.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <set>
#include <utility>

namespace pcl::indoor {

namespace {

constexpr double half_width = 0.25; // of a robot or a person, metres
constexpr double door_reach = 1.0;  // from a doorway to places in its rooms, metres
constexpr double narrowest = 0.7;   // doorway that is walked through, metres
constexpr double comfortable = 0.4; // metres to walls: nearer costs twice the way

void
addRoom(Roadmap& roadmap, const Level& level, double height)
{
  for (const auto& place : placesOn(level, height))
    if (place.free >= half_width) {
      RoadNode node;
      node.at = level.sensorAt(place.at, height);
      node.drawn = place.at;
      node.floor = level.heightAt(place.at);
      node.free = place.free;
      node.room = level.room_number;
      roadmap.push_back(node);
    }
}

void
addDoorway(Roadmap& roadmap, const Doorway& doorway, double height)
{
  RoadNode node;
  node.at = doorway.position + Eigen::Vector3d(0, 0, height);
  node.at.head<2>() += height * doorway.drift;
  node.drawn = doorway.position.head<2>();
  node.floor = doorway.position.z();
  node.free = doorway.width / 2;
  roadmap.push_back(node);
}

bool
areNeighbours(const RoadNode& a, const RoadNode& b)
{
  const double reach = a.room == 0 || b.room == 0 ? door_reach : 1.5 * place_step;
  if (a.room == b.room ? a.room == 0 : a.room != 0 && b.room != 0)
    return false;
  return (a.at - b.at).head<2>().norm() <= reach;
}

void
joinNeighbours(Roadmap& roadmap, const RayTracer& tracer)
{
  std::map<std::pair<int, int>, std::vector<int>> squares; // with sides of door_reach
  const auto squareOf = [](const RoadNode& node) {
    return std::make_pair(static_cast<int>(std::floor(node.at.x() / door_reach)),
                          static_cast<int>(std::floor(node.at.y() / door_reach)));
  };
  const auto join = [&](int i, int j) {
    if (j >= i || !areNeighbours(roadmap[i], roadmap[j]))
      return;
    if (!isClear(tracer, roadmap[i].at, roadmap[j].at))
      return;
    roadmap[i].joined.push_back(j);
    roadmap[j].joined.push_back(i);
  };
  const int count = static_cast<int>(roadmap.size());
  for (int i = 0; i < count; ++i)
    squares[squareOf(roadmap[i])].push_back(i);
  for (int i = 0; i < count; ++i) {
    const auto [x, y] = squareOf(roadmap[i]);
    for (int u = x - 1; u <= x + 1; ++u)
      for (int v = y - 1; v <= y + 1; ++v)
        if (const auto found = squares.find({u, v}); found != squares.end())
          for (const int j : found->second)
            join(i, j);
  }
}

// The places that satisfy a condition, and the joints between them.
Roadmap
selected(const Roadmap& roadmap, const std::function<bool(int)>& keep)
{
  std::vector<int> number(roadmap.size(), -1);
  Roadmap kept;
  for (std::size_t i = 0; i < roadmap.size(); ++i)
    if (keep(static_cast<int>(i))) {
      number[i] = static_cast<int>(kept.size());
      kept.push_back(roadmap[i]);
    }
  for (auto& node : kept) {
    std::vector<int> joined;
    for (const int j : node.joined)
      if (number[j] >= 0)
        joined.push_back(number[j]);
    node.joined = std::move(joined);
  }
  return kept;
}

// Rooms and the doors between them.
using RoomGraph = std::map<std::uint32_t, std::set<std::uint32_t>>;

RoomGraph
roomGraph(const Roadmap& roadmap)
{
  RoomGraph graph;
  for (const auto& node : roadmap) {
    if (node.room != 0) {
      graph[node.room];
      continue;
    }
    for (const int i : node.joined)
      for (const int j : node.joined)
        if (roadmap[i].room != roadmap[j].room)
          graph[roadmap[i].room].insert(roadmap[j].room);
  }
  return graph;
}

bool
isJoined(const RoomGraph& graph, const std::set<std::uint32_t>& rooms)
{
  std::set<std::uint32_t> reached{*rooms.begin()};
  std::vector<std::uint32_t> open{*rooms.begin()};
  while (!open.empty()) {
    const auto room = open.back();
    open.pop_back();
    for (const auto next : graph.at(room))
      if (rooms.count(next) && reached.insert(next).second)
        open.push_back(next);
  }
  return reached.size() == rooms.size();
}

// Of how much way an edge feels like: near walls it feels longer.
double
costOf(const RoadNode& a, const RoadNode& b)
{
  return (a.at - b.at).norm() * (1.0 + comfortable / std::min(a.free, b.free));
}

} // namespace

bool
isClear(const RayTracer& tracer, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  constexpr double beside = 0.1; // metres
  const Eigen::Vector3d way = to - from;
  const double length = way.head<2>().norm();
  if (length == 0)
    return true;
  const Eigen::Vector3d across(-way.y() / length, way.x() / length, 0);
  for (const double offset : {0.0, beside, -beside}) {
    const Eigen::Vector3d start = from + offset * across;
    if (tracer.trace(start.cast<float>(), way.cast<float>(), 0.0f, 1.0f).triangle >= 0)
      return false;
  }
  return true;
}

Roadmap
buildRoadmap(const Building& building,
             std::uint32_t storey,
             double height,
             const RayTracer& tracer)
{
  constexpr double same_floor = 0.5; // metres
  Roadmap roadmap;
  double floor = 0.0;
  for (std::uint32_t r = 1; r <= building.rooms.size(); ++r)
    if (building.rooms[r - 1].storey == storey) {
      addRoom(roadmap, {building, r, nullptr}, height);
      floor = building.rooms[r - 1].floor;
    }
  for (const auto& doorway : building.doorways)
    if (doorway.width > narrowest &&
        std::abs(doorway.position.z() - floor) < same_floor)
      addDoorway(roadmap, doorway, height);
  joinNeighbours(roadmap, tracer);
  return roadmap;
}

Roadmap
largestPart(const Roadmap& roadmap)
{
  std::vector<int> part(roadmap.size(), -1);
  int parts = 0, best = -1;
  std::ptrdiff_t most = 0;
  for (std::size_t first = 0; first < roadmap.size(); ++first) {
    if (part[first] >= 0)
      continue;
    std::vector<int> members{static_cast<int>(first)};
    part[first] = parts;
    for (std::size_t k = 0; k < members.size(); ++k)
      for (const int j : roadmap[members[k]].joined)
        if (part[j] < 0) {
          part[j] = parts;
          members.push_back(j);
        }
    const auto size = std::count_if(
        members.begin(), members.end(), [&](int i) { return roadmap[i].room != 0; });
    if (size > most) {
      most = size;
      best = parts;
    }
    ++parts;
  }
  return selected(roadmap, [&](int i) { return part[i] == best; });
}

Roadmap
enteredPart(const Roadmap& roadmap, double share, RandomDraw draw)
{
  const auto graph = roomGraph(roadmap);
  std::set<std::uint32_t> entered;
  for (const auto& [room, doors] : graph)
    entered.insert(room);
  const double wish = std::ceil(share * static_cast<double>(entered.size()) - 1e-9);
  const auto enough = static_cast<std::size_t>(std::max(1.0, wish));
  std::vector<std::uint32_t> order(entered.begin(), entered.end());
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[draw.pick(static_cast<int>(i))]);
  for (bool changed = true; changed && entered.size() > enough;) {
    changed = false;
    for (const auto room : order) {
      if (entered.size() <= enough || entered.erase(room) == 0)
        continue;
      if (isJoined(graph, entered))
        changed = true;
      else
        entered.insert(room);
    }
  }
  return largestPart(selected(roadmap, [&](int i) {
    return roadmap[i].room == 0 || entered.count(roadmap[i].room) > 0;
  }));
}

std::vector<int>
stopsOn(const Roadmap& roadmap, const TrajectoryOptions& options)
{
  std::map<std::uint32_t, std::vector<int>> rooms;
  for (std::size_t i = 0; i < roadmap.size(); ++i)
    if (roadmap[i].room != 0)
      rooms[roadmap[i].room].push_back(static_cast<int>(i));
  std::vector<int> stops;
  for (const auto& [room, members] : rooms) {
    std::vector<FreePlace> places;
    for (const int i : members)
      places.push_back({roadmap[i].drawn, roadmap[i].free});
    for (const auto& at : spread(places, options.spacing, options.clearance))
      stops.push_back(*std::find_if(members.begin(), members.end(), [&](int i) {
        return roadmap[i].drawn == at;
      }));
  }
  return stops;
}

std::vector<int>
wayToNearest(const Roadmap& roadmap, int from, const std::vector<char>& wanted)
{
  std::vector<double> cost(roadmap.size(), std::numeric_limits<double>::infinity());
  std::vector<int> before(roadmap.size(), -1);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost[from] = 0.0;
  open.push({0.0, from});
  while (!open.empty()) {
    const auto [so_far, i] = open.top();
    open.pop();
    if (so_far > cost[i])
      continue;
    if (wanted[i]) {
      std::vector<int> way;
      for (int k = i; k >= 0; k = before[k])
        way.push_back(k);
      std::reverse(way.begin(), way.end());
      return way;
    }
    for (const int j : roadmap[i].joined) {
      const double next = so_far + costOf(roadmap[i], roadmap[j]);
      if (next < cost[j]) {
        cost[j] = next;
        before[j] = i;
        open.push({next, j});
      }
    }
  }
  return {};
}

} // namespace pcl::indoor
