/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "random/random_table.h"

#include "plan/turned_rectangle.h"
#include "random/room_furnisher.h"

#include <pcl/simulation/random_draw.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::indoor {

namespace {

using Size = Eigen::Vector3d;

struct Object {
  const char* category;
  int first, last;        // of its variants
  Size smallest, largest; // metres
};

constexpr double side = 4.0, ceiling = 2.8; // of the room, metres

// One of eight cluttered tables is covered with objects.
bool
isDense(std::uint32_t seed)
{
  return seed % 8 == 5;
}

// Packets, books, vessels, bags and small devices, as a hand can hold them.
Piece
objectOnTable(RoomFurnisher& room)
{
  static const std::array<Object, 12> objects{
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
  const auto& object = objects[room.pick(static_cast<int>(objects.size()))];
  Size size;
  for (const int axis : {0, 1, 2})
    size[axis] = room.between(object.smallest[axis], object.largest[axis]);
  const std::string category = object.category;
  if (category == "bottle" || category == "bowl")
    size.y() = size.x();
  return room.shaped(category, object.first, object.last, size);
}

Piece
drawTable(RoomFurnisher& room)
{
  constexpr std::array<const char*, 4> tables{
      "table", "table", "round_table", "coffee_table"};
  const std::string category = tables[room.pick(static_cast<int>(tables.size()))];
  const double height =
      category == "coffee_table" ? room.between(0.35, 0.5) : room.between(0.68, 0.78);
  const double depth = room.between(0.6, 1.0), width = room.between(0.7, 1.4);
  return room.piece(category, Size(width, depth, height));
}

// Objects of all shapes that lie on tables, none longer than a hand can hold.
Piece
anyObject(RoomFurnisher& room)
{
  constexpr double longest = 0.3; // metres
  constexpr std::array<const char*, 12> objects{"bottle",
                                                "bottle",
                                                "bowl",
                                                "mug",
                                                "cup",
                                                "box",
                                                "box",
                                                "books",
                                                "clutter",
                                                "kitchenware",
                                                "toy",
                                                "bag"};
  Piece object = room.piece(objects[room.pick(static_cast<int>(objects.size()))]);
  object.size *= std::min(1.0, longest / object.size.maxCoeff());
  object.size = object.size.cwiseMax(0.02);
  return object;
}

/** How full a table is. */
struct Laying {
  int count, attempts;
  double touching, stacked; // shares of the objects
};

Laying
drawLaying(std::uint32_t seed, PlanFilling filling, RoomFurnisher& room)
{
  if (filling == PlanFilling::Plain) {
    const int count = 2 + room.pick(7);
    return {count, count, 0.3, 0.2};
  }
  if (filling == PlanFilling::LivedIn)
    return {8 + room.pick(25), 150, 0.45, 0.15};
  if (isDense(seed))
    return {22 + room.pick(11), 150, 0.55, 0.2};
  const int count = 8 + room.pick(9);
  return {count, count, 0.3, 0.2};
}

// As many as there are to be, beside and on each other.
void
layTable(RoomFurnisher& room, int table, const Laying& laying, bool any)
{
  const double top = room.sizeOf(table).z();
  int last = -1, objects = 0;
  for (int i = 0; i < laying.attempts && objects < laying.count; ++i) {
    const Piece object = any ? anyObject(room) : objectOnTable(room);
    const double turn = room.between(-M_PI, M_PI), way = room.between(0.0, 1.0);
    const bool touches = last >= 0 && way < laying.touching,
               stacked =
                   last >= 0 && !touches && way < laying.touching + laying.stacked;
    int placed = -1;
    if (touches && any)
      placed = room.restOn(table, object, {turn, false, false, 0.015, last});
    else if (touches) {
      const double gap = room.between(0.0, 0.01);
      placed = room.beside(last, object, room.chance(0.5) ? 1 : -1, gap, top);
    }
    else if (stacked)
      placed = room.onTop(last, object, room.chance(0.5) ? 0.0 : turn);
    if (placed < 0)
      placed = room.onTop(table, object, turn);
    last = placed >= 0 ? placed : last;
    objects += placed >= 0 ? 1 : 0;
  }
}

} // namespace

Plan
randomTable(std::uint32_t seed, PlanFilling filling)
{
  LayoutRoom place;
  place.outline = Eigen::AlignedBox2d(Eigen::Vector2d(-side / 2, -side / 2),
                                      Eigen::Vector2d(side / 2, side / 2));
  Plan plan;
  plan.name = "random table " + std::to_string(seed);
  plan.seed = seed;
  RoomFurnisher room(place, {}, 0, plan.wall_thickness, ceiling, mixSeed(seed, 2));
  const bool any = filling == PlanFilling::LivedIn;
  if (any)
    room.liveIn();
  Piece piece = drawTable(room);
  if (filling == PlanFilling::Cluttered && isDense(seed)) // little of it is left free
    piece.size = piece.size.cwiseMin(Size(0.95, 0.75, 1.0));
  const int table = room.inTheMiddle(piece, 0.0);
  layTable(room, table, drawLaying(seed, filling, room), any);
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

} // namespace pcl::indoor
