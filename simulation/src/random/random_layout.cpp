/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "random/random_layout.h"
#include "random/shared_walls.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

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

const char*
purposeOf(RoomKind kind, bool home)
{
  constexpr const char* purposes[] = {"corridor",
                                      "living",
                                      "kitchen",
                                      "bath",
                                      "bedroom",
                                      "office",
                                      "office",
                                      "meeting",
                                      "storage"};
  return !home && kind == RoomKind::Bathroom ? "toilet"
                                             : purposes[static_cast<int>(kind)];
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

} // namespace pcl::indoor
