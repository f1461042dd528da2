/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "random/random_table.h"

#include "random/room_furnisher.h"

#include <pcl/simulation/random_draw.h>

#include <array>
#include <cmath>

namespace pcl {
namespace indoor {

namespace {

using Size = Eigen::Vector3d;

struct Thing {
  const char* category;
  int first, last;        // of its variants
  Size smallest, largest; // metres
};

constexpr double side = 4.0, ceiling = 2.8; // of the room, metres

// Packets, books, vessels, bags and small devices, as a hand can hold them.
Piece
thingOnTable(RoomFurnisher& room)
{
  static const std::array<Thing, 12> things{
      {{"box", 0, 0, {0.05, 0.03, 0.05}, {0.25, 0.2, 0.3}},
       {"box", 0, 0, {0.1, 0.06, 0.02}, {0.3, 0.2, 0.08}},
       {"box", 0, 0, {0.05, 0.05, 0.1}, {0.12, 0.1, 0.25}},
       {"books", 0, 1, {0.1, 0.08, 0.02}, {0.25, 0.2, 0.1}},
       {"bottle", 0, 0, {0.05, 0.05, 0.12}, {0.09, 0.09, 0.3}},
       {"bottle", 0, 0, {0.06, 0.06, 0.08}, {0.11, 0.11, 0.15}},
       {"bowl", 0, 0, {0.1, 0.1, 0.03}, {0.25, 0.25, 0.12}},
       {"bowl", 0, 0, {0.08, 0.08, 0.04}, {0.2, 0.2, 0.1}},
       {"mug", 0, 0, {0.07, 0.07, 0.07}, {0.13, 0.13, 0.13}},
       {"mug", 0, 0, {0.1, 0.1, 0.06}, {0.26, 0.22, 0.18}},
       {"clutter", 0, 0, {0.08, 0.08, 0.05}, {0.25, 0.2, 0.2}},
       {"clutter", 3, 3, {0.08, 0.08, 0.05}, {0.25, 0.2, 0.12}}}};
  const auto& thing = things[room.pick(static_cast<int>(things.size()))];
  Size size;
  for (const int axis : {0, 1, 2})
    size[axis] = room.between(thing.smallest[axis], thing.largest[axis]);
  const std::string category = thing.category;
  if (category == "bottle" || category == "bowl")
    size.y() = size.x();
  return room.shaped(category, thing.first, thing.last, size);
}

Piece
drawTable(RoomFurnisher& room)
{
  constexpr std::array<const char*, 4> tables{
      "table", "table", "round_table", "coffee_table"};
  const std::string category = tables[room.pick(static_cast<int>(tables.size()))];
  return room.piece(category,
                    Size(room.between(0.7, 1.4),
                         room.between(0.6, 1.0),
                         category == "coffee_table" ? room.between(0.35, 0.5)
                                                    : room.between(0.68, 0.78)));
}

} // namespace

Plan
randomTable(std::uint32_t seed, bool cluttered)
{
  LayoutRoom place;
  place.outline = Eigen::AlignedBox2d(Eigen::Vector2d(-side / 2, -side / 2),
                                      Eigen::Vector2d(side / 2, side / 2));
  Plan plan;
  plan.name = "random table " + std::to_string(seed);
  plan.seed = seed;
  RoomFurnisher room(place, {}, 0, plan.wall_thickness, ceiling, mixSeed(seed, 2));
  const int table = room.inTheMiddle(drawTable(room), 0.0);
  const double top = room.sizeOf(table).z();
  const int count = cluttered ? 8 + room.pick(9) : 2 + room.pick(7);
  int last = -1;
  for (int i = 0; i < count; ++i) {
    const Piece thing = thingOnTable(room);
    const double turn = room.between(-M_PI, M_PI), way = room.between(0.0, 1.0);
    int placed = -1;
    if (last >= 0 && way < 0.3)
      placed = room.beside(
          last, thing, room.chance(0.5) ? 1 : -1, room.between(0.0, 0.01), top);
    else if (last >= 0 && way < 0.5)
      placed = room.onTop(last, thing, room.chance(0.5) ? 0.0 : turn);
    if (placed < 0)
      placed = room.onTop(table, thing, turn);
    last = placed >= 0 ? placed : last;
  }
  if (room.chance(0.4))
    room.around(table, "chair", 4);

  RoomPlan outline;
  outline.name = "room";
  outline.polygon = turnedRectangle({0, 0}, {side, side}, 0.0);
  outline.ceiling.planes[0].height = ceiling;
  StoreyPlan storey;
  storey.name = "ground floor";
  storey.rooms.push_back(outline);
  storey.furniture = room.furniture();
  plan.storeys.push_back(storey);
  return plan;
}

} // namespace indoor
} // namespace pcl
