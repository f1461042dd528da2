/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "random/shared_walls.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

std::optional<SharedWall>
wallBetween(const Eigen::AlignedBox2d& a, const Eigen::AlignedBox2d& b)
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
  window(int room, const SharedWall& wall, RoomKind kind)
  {
    OpeningPlan plan;
    const bool small = kind == RoomKind::Bathroom;
    plan.kind = OpeningKind::Window;
    const double longest = wall.to - wall.from - 0.6;
    plan.width = small ? std::min(longest, draw_.uniform(0.5, 0.9))
                       : draw_.uniform(0.8, std::clamp(longest, 0.81, 2.4));
    plan.sill = draw_.uniform() < 0.15 ? 0.06 : draw_.uniform(0.5, 1.0);
    if (small || kind == RoomKind::Kitchen) // over worktops and basins
      plan.sill = draw_.uniform(1.0, 1.3);
    const double top = std::min(ceiling_ - 0.15, draw_.uniform(2.0, 2.3));
    plan.height = top - plan.sill;
    plan.frame_width = draw_.uniform(0.04, 0.12);
    plan.frame_depth = draw_.uniform(0.05, 0.35);
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
        drawer.window(static_cast<int>(r), wall, rooms[r].kind);
    }
  }
  return drawer.openings;
}

} // namespace pcl::indoor
