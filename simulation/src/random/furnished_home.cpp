/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "random/furnished_rooms.h"

namespace pcl::indoor {

namespace {

void
mediaCorner(RoomFurnisher& room)
{
  const int unit = room.atWall(room.piece("tv_unit"));
  if (room.chance(0.75))
    room.onTop(unit, room.shaped("tv", 0, 2));
  if (room.chance(0.4))
    room.onTop(unit, room.piece(room.chance(0.5) ? "books" : "vase"));
}

void
seatingGroup(RoomFurnisher& room)
{
  const int sofa = room.atWall(room.piece("sofa"));
  int table = -1;
  if (room.chance(0.85)) {
    const double gap = room.between(0.2, 0.45);
    table = room.before(sofa, room.piece("coffee_table"), gap, 0, M_PI);
  }
  room.putSmallObjects(table, room.pick(4));
  if (room.chance(0.5)) {
    const int side = room.chance(0.5) ? 1 : -1;
    room.beside(sofa, room.piece("bedside_table"), side, 0.02);
  }
  for (int i = room.pick(3); i > 0; --i)
    room.anywhere(room.piece("armchair"));
}

void
diningPlace(RoomFurnisher& room, const std::string& seat)
{
  const int table =
      room.inTheMiddle(room.piece(room.chance(0.35) ? "round_table" : "table"), 0.7);
  room.around(table, seat, 2 + room.pick(5));
  room.putSmallObjects(table, room.pick(5));
  if (room.chance(0.4))
    room.fromCeiling(room.shaped("ceiling_lamp", 1, 4), table);
}

void
furnishLiving(RoomFurnisher& room)
{
  seatingGroup(room);
  if (room.chance(0.8))
    mediaCorner(room);
  if (room.chance(0.6))
    diningPlace(room, "chair");
  room.perhapsAtWall(0.2, "fireplace");
  room.perhapsAtWall(0.15, "piano");
  room.severalAtWall(3, "bookcase");
  if (room.chance(0.6))
    room.putSmallObjects(room.atWall(room.piece("cabinet")), 2);
  room.severalAtWall(2, "floor_lamp");
  room.severalAtWall(2, "plant");
  if (room.chance(0.2))
    room.anywhere(room.shaped("stool", 2, 2));
  if (room.chance(0.15))
    room.anywhere(room.piece("person"));
  if (room.chance(0.2))
    room.onWall(room.shaped("air_conditioner", 0, 0), 1.9);
  else if (room.chance(0.15))
    room.atWall(room.shaped("air_conditioner", 1, 1));
}

void
furnishKitchen(RoomFurnisher& room)
{
  room.kitchenRow(2 + room.pick(4));
  room.perhapsAtWall(0.5, "fridge");
  if (room.chance(0.4))
    room.kitchenRow(1 + room.pick(3));
  if (room.chance(0.15))
    room.putSmallObjects(room.inTheMiddle(room.shaped("kitchen_unit", 3, 3), 0.3), 3);
  else if (room.chance(0.7))
    diningPlace(room, room.chance(0.2) ? "stool" : "chair");
  room.perhapsAtWall(0.3, "cabinet");
  room.perhapsAtWall(0.7, "bin");
  if (room.chance(0.4))
    room.hang("shelf", 1.2, 1.6);
}

void
furnishBathroom(RoomFurnisher& room)
{
  room.perhapsAtWall(0.6, "bath");
  room.perhapsAtWall(0.5, "shower");
  room.atWall(room.piece("toilet"));
  if (room.chance(0.3)) {
    const double height = room.between(0.52, 0.62);
    room.atWall(room.shaped("sink", 2, 2), height);
  }
  else
    room.atWall(room.shaped("sink", 0, 1));
  room.perhapsAtWall(0.5, "washing_machine");
  if (room.chance(0.3))
    room.atWall(room.piece("cabinet", Eigen::Vector3d(0.45, 0.35, 1.6)));
  room.perhapsAtWall(0.4, "stool");
  room.perhapsAtWall(0.5, "bin");
  if (room.chance(0.5)) // a mirror
    room.onWall(room.piece("picture"), 1.2);
  if (room.chance(0.5))
    room.hang("wall_lamp", 1.7, 1.95);
}

void
furnishBedroom(RoomFurnisher& room)
{
  const bool bunk = room.chance(0.15);
  const int bed = room.atWall(room.piece(bunk ? "bunk_bed" : "bed"));
  for (const int side : {-1, 1})
    if (!bunk && room.chance(0.7)) {
      const double gap = room.between(0.005, 0.08);
      const int table = room.beside(bed, room.piece("bedside_table"), side, gap);
      if (room.chance(0.6))
        room.onTop(table, room.piece("table_lamp"));
      else
        room.putSmallObjects(table, 1);
    }
  for (int i = 1 + room.pick(2); i > 0; --i)
    room.atWall(room.piece("wardrobe"));
  if (room.chance(0.5)) {
    const int objects = room.pick(3);
    room.putSmallObjects(room.atWall(room.piece("drawers")), objects);
  }
  if (room.chance(0.4))
    room.workplace(room.piece("desk"), "chair", 0.0);
  room.perhapsAtWall(0.3, "bookcase");
  if (room.chance(0.25))
    room.atWall(room.piece(room.chance(0.5) ? "chair" : "armchair"));
  if (room.chance(0.2))
    room.before(bed, room.piece("bench"), 0.03, 0, M_PI);
  room.perhapsAtWall(0.3, "plant");
  if (room.chance(0.3)) {
    const double height = room.between(1.0, 1.4);
    room.onWall(room.shaped("tv", 1, 1), height);
  }
  if (room.chance(0.3))
    room.hang("shelf", 1.2, 1.6);
  room.perhapsAtWall(0.2, "ball");
}

void
furnishStudy(RoomFurnisher& room)
{
  room.workplace(room.piece("desk"), "office_chair", 0.2);
  for (int i = 1 + room.pick(3); i > 0; --i)
    room.atWall(room.piece("bookcase"));
  if (room.chance(0.5))
    room.putSmallObjects(room.atWall(room.piece("drawers")), 1);
  if (room.chance(0.3))
    room.anywhere(room.piece("treadmill"));
  room.perhapsAtWall(0.2, "piano");
  room.perhapsAtWall(0.3, "rack");
  room.perhapsAtWall(0.4, "armchair");
  room.perhapsAtWall(0.4, "floor_lamp");
}

void
furnishHall(RoomFurnisher& room)
{
  if (room.chance(0.5)) {
    const int objects = room.pick(3);
    room.putSmallObjects(
        room.atWall(room.piece(room.chance(0.5) ? "cabinet" : "drawers")), objects);
  }
  room.perhapsAtWall(0.4, "wardrobe");
  room.perhapsAtWall(0.4, "coat_rack");
  room.perhapsAtWall(0.3, "bench");
  room.perhapsAtWall(0.15, "bicycle");
  room.perhapsAtWall(0.3, "plant");
  if (room.chance(0.1))
    room.anywhere(room.piece("person"));
}

void
finish(RoomFurnisher& room, bool dry)
{
  room.radiatorsBelowWindows();
  if (room.chance(0.8))
    room.fromCeiling(room.shaped("ceiling_lamp", 1, 5));
  if (!dry)
    return;
  room.curtains(0.5);
  for (int i = room.pick(3); i > 0; --i)
    room.hang("picture", 1.1, 1.5);
  for (int i = room.pick(2); i > 0; --i)
    room.hang("wall_lamp", 1.5, 1.9);
  for (int i = room.pick(3); i > 0; --i)
    room.anywhere(room.piece(room.chance(0.8) ? "box" : "bin"));
}

} // namespace

void
furnishHomeRoom(RoomFurnisher& room, RoomKind kind)
{
  switch (kind) {
  case RoomKind::Living:
    furnishLiving(room);
    break;
  case RoomKind::Kitchen:
    furnishKitchen(room);
    break;
  case RoomKind::Bathroom:
    furnishBathroom(room);
    break;
  case RoomKind::Bedroom:
    furnishBedroom(room);
    break;
  case RoomKind::Study:
    furnishStudy(room);
    break;
  default:
    furnishHall(room);
  }
  finish(room, kind != RoomKind::Bathroom);
}

} // namespace pcl::indoor
