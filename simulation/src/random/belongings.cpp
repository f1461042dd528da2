/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "random/furnished_rooms.h"
#include "random/habits.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

// A whole number that is expected on average.
int
countOf(RoomFurnisher& room, double expected)
{
  return static_cast<int>(expected + room.between(0.0, 1.0));
}

bool
isFlat(const Piece& piece)
{
  const std::string& c = piece.category;
  return c == "books" || c == "box" || (c == "clutter" && piece.size.z() < 0.12);
}

// Two thirds of the width of a bed or sofa, a part of its depth, down to its sides.
void
spread(RoomFurnisher& room, int on, Piece cloth)
{
  const Eigen::Vector3d size = room.sizeOf(on);
  const std::string& base = room.furniture()[static_cast<std::size_t>(on)].category;
  const bool bed = base == "bed" || base == "bunk_bed",
             edge = base == "radiator" || base == "bath" || base == "kitchen_unit";
  double hem = room.between(0.1, 0.35) * size.z();
  Eigen::Vector2d at(room.between(-0.3, 0.3) * size.x(), 0);
  if (cloth.category != "blanket") {
    cloth.size.y() = room.between(0.5, 0.8);
    cloth.size.x() = room.between(0.35, 0.6);
  }
  else if (bed) {
    cloth.size.y() = room.between(0.3, 0.75) * size.y();
    cloth.size.x() = size.x() + room.between(-0.3, 0.3);
    at = {room.between(-0.1, 0.1),
          room.between(0.0, 1.0) * (size.y() - cloth.size.y()) / 2 + 0.05};
  }
  else {
    cloth.size.y() = std::min(1.6, room.between(0.8, 1.15) * size.y());
    cloth.size.x() = room.between(0.6, 1.3);
  }
  if (edge) { // from its front edge down
    cloth.size.y() = room.between(0.2, 0.4);
    cloth.size.x() = std::min(cloth.size.x(), 0.8 * size.x());
    at.y() = size.y() / 2 - 0.3 * cloth.size.y();
    hem = room.between(0.3, 0.6) * size.z();
  }
  room.layOver(on, cloth, at, hem);
}

void
overBack(RoomFurnisher& room, int on, Piece cloth)
{
  const Eigen::Vector3d size = room.sizeOf(on);
  cloth.size.y() = room.between(0.25, 0.45);
  cloth.size.x() = room.between(0.7, 1.0) * size.x();
  const double hem = room.between(0.35, 0.6) * size.z(),
               aside = room.between(-0.1, 0.1) * size.x();
  room.layOver(on, cloth, {aside, -size.y() / 2 + 0.06}, hem);
}

// One object where it is usually found; the number of the last that lies there.
int
place(RoomFurnisher& room, const Habit& habit, int on, int last)
{
  const Piece object = room.shaped(habit.object, habit.first, habit.last);
  const double turn =
      room.chance(0.5) ? room.between(-0.2, 0.2) : room.between(-M_PI, M_PI);
  Resting how;
  how.turn = turn;
  how.touching = last >= 0 && room.chance(0.4) ? last : -1;
  switch (habit.where) {
  case Where::On:
    if (last >= 0 && isFlat(object) && room.chance(0.2))
      if (const int placed = room.restOn(last, object, how); placed >= 0)
        return placed;
    return room.restOn(on, object, how);
  case Where::In:
    how.inside = true;
    how.turn = object.category == "books" ? 0.0 : room.between(-0.2, 0.2);
    return room.restOn(on, object, how);
  case Where::Seat:
    how.give = 0.06;
    how.at_rear = object.category == "pillow" && object.variant == 1;
    how.turn = how.at_rear ? room.between(-0.2, 0.2) : turn;
    how.touching = -1;
    return room.restOn(on, object, how);
  case Where::Below:
    return room.under(on, object);
  case Where::Around:
    if (room.chance(0.5)) {
      const double aside = room.between(-0.4, 0.4) * room.sizeOf(on).x();
      return room.before(on, object, room.between(0.0, 0.15), aside, turn);
    }
    else {
      const double gap = room.between(0.0, 0.1);
      return room.beside(on, object, room.chance(0.5) ? 1 : -1, gap);
    }
  case Where::Over:
    spread(room, on, object);
    return -1;
  case Where::Back:
    overBack(room, on, object);
    return -1;
  }
  return -1;
}

void
follow(RoomFurnisher& room, const std::vector<Habit>& habits, bool cloths)
{
  const int count = static_cast<int>(room.furniture().size());
  for (int on = 0; on < count; ++on) {
    const std::string category =
        room.furniture()[static_cast<std::size_t>(on)].category;
    int last = -1;
    for (const auto& habit : habits) {
      const bool is_cloth = habit.where == Where::Over || habit.where == Where::Back;
      if (is_cloth != cloths ||
          std::find(habit.pieces.begin(), habit.pieces.end(), category) ==
              habit.pieces.end())
        continue;
      for (int i = countOf(room, habit.expected); i > 0; --i) {
        const int placed = place(room, habit, on, last);
        last = placed >= 0 ? placed : last;
      }
    }
  }
}

} // namespace

void
addBelongings(RoomFurnisher& room, RoomKind kind)
{
  constexpr double usual_area = 12.0; // square metres that customs are meant for
  const double share = std::clamp(room.size().prod() / usual_area, 0.5, 2.5),
               mess = room.between(0.3, 1.5);
  room.curtains(kind == RoomKind::Bathroom ? 0.2 : 0.45, "blinds");
  for (const auto& custom : customs()) {
    if (custom.room != kind)
      continue;
    for (int i = countOf(room, mess * share * custom.expected); i > 0; --i) {
      const Piece object = room.shaped(custom.object, custom.first, custom.last);
      if (custom.elevation < 0)
        room.anywhere(object);
      else if (custom.elevation == 0)
        room.atWall(object);
      else
        room.onWall(object, custom.elevation + room.between(-0.1, 0.1));
    }
  }
  for (auto habits : {seatHabits(), tableHabits(), storageHabits()}) {
    for (auto& habit : habits)
      habit.expected *= mess;
    follow(room, habits, false);
    follow(room, habits, true);
  }
}

} // namespace pcl::indoor
