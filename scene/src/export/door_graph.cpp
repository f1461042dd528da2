/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/door_graph.h"

#include "export/opening_place.h"
#include "export/room_ways.h"
#include "files/tool_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::indoor::tool {
namespace {

constexpr double clearance = 0.3; // metres from corners and in front of doors
constexpr double nearby = 1.0;    // metres that a place may be outside of a room

/** How far a place is outside of a room; 0 inside. */
double
distanceOutside(const SavedRoom& room, const Eigen::Vector2d& place)
{
  return isInside(room.rings, place) ? 0.0 : distanceToSides(room.rings, place);
}

/** Stairs and the rooms at their ends. */
struct Stairs {
  std::uint32_t object = 0;
  std::array<std::uint32_t, 2> rooms = {0, 0}; ///< below and above
  std::array<Eigen::Vector2d, 2> ends;
};

/** The nearest room of a storey, within some distance; 0 = none. */
std::uint32_t
roomNear(const SavedScene& scene,
         std::uint32_t storey,
         const Eigen::Vector2d& place,
         double within)
{
  std::uint32_t found = 0;
  double nearest = within;
  for (const auto& room : scene.rooms) {
    if (room.storey != storey)
      continue;
    const double distance = distanceOutside(room, place);
    if (distance < nearest || (found == 0 && distance <= nearest)) {
      nearest = distance;
      found = room.number;
    }
  }
  return found;
}

/** Do stairs go up from a storey most of the way to the next one, and end there? A
 * railing may stand above. */
bool
leadsUp(const SavedScene& scene, const SavedObject& object)
{
  constexpr double most = 0.6;
  constexpr double railing = 1.5; // metres
  if (object.is_structure || object.name != "stairs" ||
      object.storey + 1 >= scene.storeys.size())
    return false;
  const double top = object.box.center.z() + 0.5 * object.box.size.z();
  const double floor = scene.storeys[object.storey].floor;
  const double next = scene.storeys[object.storey + 1].floor;
  return top - floor > most * (next - floor) && top < next + railing;
}

/** Where one stands at an end of stairs: before it, if the room goes on there. */
Eigen::Vector2d
standAtEnd(const SavedRoom& room,
           const Eigen::Vector2d& end,
           const Eigen::Vector2d& way)
{
  for (const double further :
       {clearance, 0.5 * clearance, -0.5 * clearance, -clearance})
    if (isInside(room.rings, end + further * way))
      return end + further * way;
  return end;
}

/** Which end is below is not known: rooms are nearer to those that are right. */
std::optional<Stairs>
stairsOf(const SavedScene& scene, const SavedObject& object)
{
  constexpr double reach = 2.0; // metres from the stairs to the room above
  if (!leadsUp(scene, object))
    return {};
  const auto& box = object.box;
  const Eigen::Vector2d way(std::cos(box.yaw), std::sin(box.yaw));
  const Eigen::Vector2d half = 0.5 * box.size.x() * way;
  std::optional<Stairs> best;
  double least = std::numeric_limits<double>::infinity();
  for (const double sign : {1.0, -1.0}) {
    const Eigen::Vector2d below = box.center.head<2>() - sign * half;
    const Eigen::Vector2d above = box.center.head<2>() + sign * half;
    const std::uint32_t lower =
        object.room > 0 ? object.room : roomNear(scene, object.storey, below, reach);
    const auto upper = roomNear(scene, object.storey + 1, above, reach);
    if (lower == 0 || upper == 0)
      continue;
    const double outside = distanceOutside(scene.rooms[lower - 1], below) +
                           distanceOutside(scene.rooms[upper - 1], above);
    if (outside < least) {
      least = outside;
      best = Stairs{object.number,
                    {lower, upper},
                    {standAtEnd(scene.rooms[lower - 1], below, -sign * way),
                     standAtEnd(scene.rooms[upper - 1], above, sign * way)}};
    }
  }
  return best;
}

/** Where one stands in a room before an opening; the opening itself if that is nowhere.
 */
Eigen::Vector2d
standBefore(const SavedRoom& room, const OpeningPlace& opening)
{
  constexpr double step = 0.05; // metres
  const Eigen::Vector2d left(-opening.along.y(), opening.along.x());
  for (int i = 1; i <= 20; ++i)
    for (const Eigen::Vector2d& way : {left, Eigen::Vector2d(-left)}) {
      const Eigen::Vector2d first = opening.middle + step * i * way;
      if (!isInside(room.rings, first))
        continue;
      const Eigen::Vector2d further = first + clearance * way;
      return isInside(room.rings, further) && seesEachOther(room.rings, first, further)
                 ? further
                 : first;
    }
  return opening.middle;
}

/** Makes the graph, room by room. */
class GraphMaker {
public:
  explicit GraphMaker(const SavedScene& scene)
  : scene_(scene)
  , in_room_(scene.rooms.size())
  {}

  DoorGraph
  graph(const std::vector<Eigen::Vector3d>& places);

private:
  std::size_t
  addNode(DoorNodeKind kind,
          std::uint32_t number,
          std::uint32_t room,
          const Eigen::Vector3d& position);

  void
  addOpening(const SavedOpening& opening);

  void
  addStairs(const Stairs& stairs);

  void
  addPlace(std::uint32_t number, const Eigen::Vector3d& place);

  void
  addRoomWays(const SavedRoom& room);

  void
  join(std::size_t a, std::size_t b)
  {
    const auto &from = graph_.nodes[a].position, &to = graph_.nodes[b].position;
    graph_.lines.push_back({a, b, (from - to).norm()});
  }

  /** A node, and where in a room one stands to go there. */
  struct Entrance {
    std::size_t node;
    Eigen::Vector2d stand;
  };

  const SavedScene& scene_;
  DoorGraph graph_;
  std::vector<std::vector<Entrance>> in_room_;
};

std::size_t
GraphMaker::addNode(DoorNodeKind kind,
                    std::uint32_t number,
                    std::uint32_t room,
                    const Eigen::Vector3d& position)
{
  DoorNode node;
  node.kind = kind;
  node.number = number;
  node.room = room;
  node.storey = room > 0 ? scene_.rooms[room - 1].storey : 0;
  node.position = position;
  graph_.nodes.push_back(node);
  return graph_.nodes.size() - 1;
}

void
GraphMaker::addOpening(const SavedOpening& opening)
{
  const auto place = openingPlace(scene_, opening);
  const auto node = addNode(DoorNodeKind::Opening, opening.number, 0, opening.position);
  graph_.nodes[node].storey = opening.storey;
  for (const auto room : {opening.room_a, opening.room_b})
    if (room > 0)
      in_room_[room - 1].push_back({node, standBefore(scene_.rooms[room - 1], place)});
}

void
GraphMaker::addStairs(const Stairs& stairs)
{
  std::size_t ends[2] = {};
  for (int i = 0; i < 2; ++i) {
    const auto& room = scene_.rooms[stairs.rooms[i] - 1];
    const auto& end = stairs.ends[i];
    ends[i] = addNode(DoorNodeKind::Stair,
                      stairs.object,
                      room.number,
                      {end.x(), end.y(), room.floor});
    in_room_[room.number - 1].push_back({ends[i], end});
  }
  join(ends[0], ends[1]);
}

void
GraphMaker::addPlace(std::uint32_t number, const Eigen::Vector3d& place)
{
  const auto storey = storeyAt(place.z(), scene_.storeys);
  const auto room = roomNear(scene_, storey, place.head<2>(), nearby);
  if (room == 0)
    throw ToolError("place " + std::to_string(number) + " is in no room");
  const Eigen::Vector3d position(place.x(), place.y(), scene_.rooms[room - 1].floor);
  in_room_[room - 1].push_back(
      {addNode(DoorNodeKind::Place, number, room, position), place.head<2>()});
}

void
GraphMaker::addRoomWays(const SavedRoom& room)
{
  std::vector<Eigen::Vector2d> places;
  for (const auto& entrance : in_room_[room.number - 1])
    places.push_back(entrance.stand);
  const auto ways = roomWays(room.rings, places, clearance);
  std::vector<std::size_t> nodes(ways.points.size(), ways.points.size());
  std::vector<bool> is_new(ways.points.size(), true);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto node = in_room_[room.number - 1][i].node;
    const auto& position = graph_.nodes[node].position;
    if (position.head<2>() != places[i])
      continue;
    nodes[i] = node;
    is_new[i] = false;
  }
  for (const auto& [a, b] : ways.lines) {
    for (const auto i : {a, b})
      if (is_new[i]) {
        const auto& point = ways.points[i];
        nodes[i] = addNode(
            DoorNodeKind::Corner, 0, room.number, {point.x(), point.y(), room.floor});
        is_new[i] = false;
        if (i < places.size())
          join(in_room_[room.number - 1][i].node, nodes[i]);
      }
    join(nodes[a], nodes[b]);
  }
}

DoorGraph
GraphMaker::graph(const std::vector<Eigen::Vector3d>& places)
{
  for (const auto& room : scene_.rooms) {
    const auto middle = widestPlace(room.rings);
    const auto node = addNode(DoorNodeKind::Room,
                              room.number,
                              room.number,
                              {middle.x(), middle.y(), room.floor});
    in_room_[room.number - 1].push_back({node, middle});
  }
  for (const auto& opening : scene_.openings)
    if (opening.kind != ModelOpeningKind::Window)
      addOpening(opening);
  for (const auto& object : scene_.objects)
    if (const auto stairs = stairsOf(scene_, object))
      addStairs(*stairs);
  for (std::size_t i = 0; i < places.size(); ++i)
    addPlace(static_cast<std::uint32_t>(i + 1), places[i]);
  for (const auto& room : scene_.rooms)
    addRoomWays(room);
  return std::move(graph_);
}

} // namespace

DoorGraph
doorGraph(const SavedScene& scene, const std::vector<Eigen::Vector3d>& places)
{
  return GraphMaker(scene).graph(places);
}

std::optional<DoorRoute>
shortestRoute(const DoorGraph& graph, std::size_t from, std::size_t to)
{
  const auto paths = ShortestPaths(graph.nodes.size(), graph.lines).from(from);
  DoorRoute route;
  route.nodes = paths.to(to);
  route.length = paths.lengths[to];
  if (route.nodes.empty())
    return {};
  return route;
}

std::size_t
nodeOf(const DoorGraph& graph, DoorNodeKind kind, std::uint32_t number)
{
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    if (graph.nodes[i].kind == kind && graph.nodes[i].number == number)
      return i;
  throw ToolError("there is no " +
                  std::string(kind == DoorNodeKind::Room ? "room " : "node ") +
                  std::to_string(number));
}

} // namespace pcl::indoor::tool
