/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "random_layout.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace indoor {

namespace {

using Box = Eigen::AlignedBox2d;

constexpr double narrowest = 2.1; // metres, between middle lines of a room's walls

Box
makeBox(double x0, double y0, double x1, double y1)
{
  return {Eigen::Vector2d(x0, y0), Eigen::Vector2d(x1, y1)};
}

double
areaOf(const Box& box)
{
  return box.sizes().prod();
}

// Two boxes side by side: the first ends at a share of the length along an axis.
std::array<Box, 2>
cut(const Box& box, int axis, double length)
{
  std::array<Box, 2> halves{box, box};
  halves[0].max()[axis] = halves[1].min()[axis] = box.min()[axis] + length;
  return halves;
}

int
longAxis(const Box& box)
{
  return box.sizes().x() >= box.sizes().y() ? 0 : 1;
}

// Cut the largest boxes until there are enough, or none is long enough to cut.
void
subdivide(std::vector<Box>& boxes, std::size_t count, RandomDraw& draw)
{
  while (boxes.size() < count) {
    const auto largest =
        std::max_element(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) {
          return areaOf(a) < areaOf(b);
        });
    const int axis = longAxis(*largest);
    const double length = largest->sizes()[axis];
    if (length < 2 * narrowest)
      return;
    const double at =
        std::clamp(length * draw.uniform(0.35, 0.65), narrowest, length - narrowest);
    const auto halves = cut(*largest, axis, at);
    *largest = halves[0];
    boxes.push_back(halves[1]);
  }
}

// The outline of a home: a rectangle or an L.
std::vector<Box>
drawOutline(double area, RandomDraw& draw)
{
  const bool bent = draw.uniform() < 0.4;
  const double aspect = draw.uniform(1.0, 1.7), full = bent ? area / 0.75 : area;
  const double w = std::sqrt(full * aspect), h = full / w;
  if (!bent)
    return {makeBox(0, 0, w, h)};
  const double low = h * draw.uniform(0.45, 0.6), left = w * draw.uniform(0.45, 0.65);
  return {makeBox(0, 0, w, low), makeBox(0, low, left, h)};
}

struct SharedWall {
  int room = -1; // the neighbour
  int axis = 0;  // along which the wall runs
  double at = 0, from = 0, to = 0;
};

// The wall between two rooms, if any.
std::optional<SharedWall>
wallBetween(const Box& a, const Box& b)
{
  for (const int axis : {0, 1}) {
    const int across = 1 - axis;
    for (const bool upper : {false, true}) {
      const double at = upper ? a.max()[across] : a.min()[across];
      const double other = upper ? b.min()[across] : b.max()[across];
      const double from = std::max(a.min()[axis], b.min()[axis]);
      const double to = std::min(a.max()[axis], b.max()[axis]);
      if (std::abs(at - other) < 1e-9 && to - from > 1e-6)
        return SharedWall{-1, axis, at, from, to};
    }
  }
  return std::nullopt;
}

std::vector<SharedWall>
wallsOf(const std::vector<LayoutRoom>& rooms, std::size_t r)
{
  constexpr double shortest = 1.5; // metres: a door, its frame and half of two walls
  std::vector<SharedWall> walls;
  for (std::size_t o = 0; o < rooms.size(); ++o)
    if (o != r)
      if (auto wall = wallBetween(rooms[r].outline, rooms[o].outline)) {
        wall->room = static_cast<int>(o);
        if (wall->to - wall->from >= shortest)
          walls.push_back(*wall);
      }
  return walls;
}

// Rooms in the order in which doors reach them from the hall, each with its wall to the
// room before it.
std::vector<std::pair<int, SharedWall>>
treeOfDoors(const std::vector<LayoutRoom>& rooms)
{
  std::vector<bool> reached(rooms.size(), false);
  std::vector<int> queue;
  const auto hall = std::find_if(rooms.begin(), rooms.end(), [](const auto& room) {
    return room.kind == RoomKind::Hall;
  });
  queue.push_back(static_cast<int>(hall - rooms.begin()));
  reached[queue[0]] = true;
  std::vector<std::pair<int, SharedWall>> tree;
  for (std::size_t next = 0; next < queue.size(); ++next)
    for (const auto& wall : wallsOf(rooms, queue[next]))
      if (!reached[wall.room]) {
        reached[wall.room] = true;
        queue.push_back(wall.room);
        tree.emplace_back(queue[next], wall);
      }
  return tree;
}

void
nameRooms(std::vector<LayoutRoom>& rooms, bool upper, RandomDraw& draw)
{
  std::vector<LayoutRoom*> left;
  for (auto& room : rooms)
    if (room.kind != RoomKind::Hall)
      left.push_back(&room);
  std::sort(left.begin(), left.end(), [](const auto* a, const auto* b) {
    return areaOf(a->outline) < areaOf(b->outline);
  });
  left.front()->kind = RoomKind::Bathroom;
  left.erase(left.begin());
  if (!upper) {
    left.back()->kind = RoomKind::Living;
    left.pop_back();
    const auto kitchen = left.begin() + draw.pick(static_cast<int>(left.size()));
    (*kitchen)->kind = RoomKind::Kitchen;
    left.erase(kitchen);
  }
  for (auto* room : left)
    room->kind = draw.uniform() < 0.75 ? RoomKind::Bedroom : RoomKind::Study;
}

} // namespace

const char*
nameOf(RoomKind kind)
{
  constexpr const char* names[] = {"hall",
                                   "living room",
                                   "kitchen",
                                   "bathroom",
                                   "bedroom",
                                   "study",
                                   "office",
                                   "meeting room",
                                   "storage"};
  return names[static_cast<int>(kind)];
}

std::vector<LayoutRoom>
drawHomeRooms(RandomDraw& draw)
{
  while (true) { // most draws are good
    const std::size_t count = 4 + static_cast<std::size_t>(draw.pick(5));
    auto boxes =
        drawOutline(static_cast<double>(count) * draw.uniform(10.0, 16.0), draw);
    std::optional<Box> strip;
    const int axis = longAxis(boxes[0]);
    const double width = draw.uniform(1.5, 2.5), depth = boxes[0].sizes()[1 - axis];
    if (draw.uniform() < 0.6 && depth > width + 2 * 2.4) {
      const double before = draw.uniform(2.4, depth - width - 2.4);
      const auto first = cut(boxes[0], 1 - axis, before);
      const auto second = cut(first[1], 1 - axis, width);
      boxes[0] = first[0];
      boxes.push_back(second[1]);
      strip = second[0];
    }
    subdivide(boxes, count - (strip ? 1 : 0), draw);
    if (strip)
      boxes.push_back(*strip);
    std::vector<LayoutRoom> rooms;
    for (const auto& box : boxes)
      rooms.push_back({box, RoomKind::Living});
    const auto most = [&](std::size_t a, std::size_t b) {
      return wallsOf(rooms, a).size() < wallsOf(rooms, b).size();
    };
    std::size_t hall = boxes.size() - 1;
    for (std::size_t r = 0; !strip && r < rooms.size(); ++r)
      hall = most(hall, r) ? r : hall;
    rooms[hall].kind = RoomKind::Hall;
    if (rooms.size() < 4 || !canBeJoined(rooms))
      continue;
    nameRooms(rooms, false, draw);
    return rooms;
  }
}

std::vector<LayoutRoom>
asUpperFloor(std::vector<LayoutRoom> rooms, RandomDraw& draw)
{
  nameRooms(rooms, true, draw);
  return rooms;
}

std::vector<LayoutRoom>
drawOfficeRooms(RandomDraw& draw)
{
  const double length = draw.uniform(12.0, 24.0), corridor = draw.uniform(1.7, 2.6);
  const double south = draw.uniform(3.6, 5.5), north = draw.uniform(3.6, 5.5);
  std::vector<LayoutRoom> rooms{
      {makeBox(0, south, length, south + corridor), RoomKind::Hall}};
  const double sides[2][2] = {{0, south}, {south + corridor, south + corridor + north}};
  for (const auto& side : sides) {
    double x = 0;
    while (x < length) {
      double width = draw.uniform(2.6, 6.5);
      if (length - x - width < 2.6)
        width = length - x;
      RoomKind kind = RoomKind::Office;
      const double choice = draw.uniform();
      if (choice < 0.1 && width < 4.0)
        kind = RoomKind::Storage;
      else if (choice < 0.18 && width < 4.0)
        kind = RoomKind::Bathroom;
      else if (choice < 0.3)
        kind = RoomKind::Kitchen;
      else if (choice < 0.5 && width > 3.6)
        kind = RoomKind::Meeting;
      rooms.push_back({makeBox(x, side[0], x + width, side[1]), kind});
      x += width;
    }
  }
  return rooms;
}

bool
canBeJoined(const std::vector<LayoutRoom>& rooms)
{
  return treeOfDoors(rooms).size() + 1 == rooms.size();
}

namespace {

// Puts openings into walls so that they do not overlap.
class OpeningDrawer {
public:
  OpeningDrawer(double ceiling, RandomDraw& draw)
  : ceiling_(ceiling)
  , draw_(draw)
  {}

  void
  door(int room, const SharedWall& wall)
  {
    OpeningPlan plan;
    plan.width = draw_.uniform(0.8, 1.0);
    plan.height = std::min(draw_.uniform(1.98, 2.15), ceiling_ - 0.2);
    const double state = draw_.uniform();
    if (state > 0.75)
      plan.leaf_angle = draw_.uniform(0.3, 1.0);
    else if (state > 0.25)
      plan.leaf_angle = draw_.uniform(1.1, 1.6);
    plan.hinge_left = draw_.pick(2) == 0;
    put(plan, room, wall);
  }

  void
  passage(int room, const SharedWall& wall)
  {
    OpeningPlan plan;
    plan.kind = OpeningKind::Passage;
    plan.width = draw_.uniform(0.9, std::min(2.4, wall.to - wall.from - 0.5));
    plan.height = std::min(draw_.uniform(2.0, 2.4), ceiling_ - 0.1);
    put(plan, room, wall);
  }

  void
  frontDoor(int room, const SharedWall& wall)
  {
    OpeningPlan plan;
    plan.width = draw_.uniform(0.9, 1.05);
    plan.height = std::min(2.1, ceiling_ - 0.2);
    put(plan, room, wall);
  }

  void
  window(int room, const SharedWall& wall, bool small)
  {
    OpeningPlan plan;
    plan.kind = OpeningKind::Window;
    const double longest = wall.to - wall.from - 0.6;
    plan.width = small ? std::min(longest, draw_.uniform(0.5, 0.9))
                       : draw_.uniform(0.8, std::clamp(longest, 0.81, 2.4));
    plan.sill = small                    ? draw_.uniform(1.1, 1.4)
                : draw_.uniform() < 0.15 ? 0.06
                                         : draw_.uniform(0.5, 1.0);
    const double top = std::min(ceiling_ - 0.15, draw_.uniform(2.0, 2.3));
    plan.height = top - plan.sill;
    put(plan, room, wall);
  }

  std::vector<LayoutOpening> openings;

private:
  void
  put(OpeningPlan plan, int room, const SharedWall& wall)
  {
    constexpr double corner = 0.25; // metres, more than half of a wall
    const double least = wall.from + corner + plan.width / 2;
    const double most = wall.to - corner - plan.width / 2;
    if (least > most)
      return;
    for (int attempt = 0; attempt < 8; ++attempt) {
      // As often near the end of the wall as anywhere.
      double at = draw_.uniform(least, most);
      if (plan.kind == OpeningKind::Door && draw_.pick(2) == 0)
        at = draw_.pick(2) == 0 ? least : most;
      plan.at[wall.axis] = at;
      plan.at[1 - wall.axis] = wall.at;
      const bool free = std::none_of(
          openings.begin(), openings.end(), [&](const LayoutOpening& other) {
            return std::abs(other.plan.at[1 - wall.axis] - wall.at) < 1e-9 &&
                   std::abs(other.plan.at[wall.axis] - at) <
                       (other.plan.width + plan.width) / 2 + 0.1;
          });
      if (!free)
        continue;
      openings.push_back({plan, {room, wall.room}});
      return;
    }
  }

  double ceiling_;
  RandomDraw& draw_;
};

// The pieces of a room's outer walls.
std::vector<SharedWall>
outerWalls(const std::vector<LayoutRoom>& rooms, std::size_t r)
{
  std::vector<SharedWall> pieces;
  const auto& box = rooms[r].outline;
  for (const int axis : {0, 1})
    for (const bool upper : {false, true}) {
      const double at = upper ? box.max()[1 - axis] : box.min()[1 - axis];
      std::vector<std::pair<double, double>> inner;
      for (std::size_t o = 0; o < rooms.size(); ++o)
        if (o != r)
          if (const auto wall = wallBetween(box, rooms[o].outline))
            if (wall->axis == axis && std::abs(wall->at - at) < 1e-9)
              inner.emplace_back(wall->from, wall->to);
      std::sort(inner.begin(), inner.end());
      inner.emplace_back(box.max()[axis], box.max()[axis]);
      double from = box.min()[axis];
      for (const auto& [begin, end] : inner) {
        if (begin - from > 1.2)
          pieces.push_back({-1, axis, at, from, begin});
        from = std::max(from, end);
      }
    }
  return pieces;
}

} // namespace

std::vector<LayoutOpening>
drawOpenings(const std::vector<LayoutRoom>& rooms,
             double ceiling,
             bool front_door,
             RandomDraw& draw)
{
  OpeningDrawer drawer(ceiling, draw);
  const auto tree = treeOfDoors(rooms);
  for (const auto& [room, wall] : tree) {
    const RoomKind a = rooms[room].kind, b = rooms[wall.room].kind;
    const auto open = [](RoomKind kind) {
      return kind == RoomKind::Hall || kind == RoomKind::Living ||
             kind == RoomKind::Kitchen;
    };
    if (open(a) && open(b) && draw.uniform() < 0.3)
      drawer.passage(room, wall);
    else
      drawer.door(room, wall);
  }
  bool needs_door = front_door;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const bool hall = rooms[r].kind == RoomKind::Hall;
    for (const auto& wall : outerWalls(rooms, r)) {
      if (hall && needs_door) {
        drawer.frontDoor(static_cast<int>(r), wall);
        needs_door = false;
      }
      else if (draw.uniform() < (hall ? 0.3 : 0.75))
        drawer.window(static_cast<int>(r), wall, rooms[r].kind == RoomKind::Bathroom);
    }
  }
  return drawer.openings;
}

} // namespace indoor
} // namespace pcl
