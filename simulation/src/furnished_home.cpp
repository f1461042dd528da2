/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "room_furnisher.h"

namespace pcl {
namespace indoor {

namespace {

void
lightAndHeat(RoomFurnisher& room)
{
  room.belowWindows("radiator", 0.6);
  if (room.chance(0.7))
    room.fromCeiling(room.piece("ceiling_lamp"));
}

void
furnishLiving(RoomFurnisher& room)
{
  const int sofa = room.atWall(room.piece("sofa"));
  if (room.chance(0.8))
    room.before(sofa, room.piece("table", Eigen::Vector3d(1.1, 0.6, 0.45)), 0.35, 0, 0);
  if (room.chance(0.5))
    room.atWall(room.piece("cabinet"));
  for (int i = room.pick(3); i > 0; --i)
    room.anywhere(room.piece("armchair"));
  if (room.chance(0.7)) {
    const int table =
        room.inTheMiddle(room.piece(room.chance(0.3) ? "round_table" : "table"), 0.7);
    room.around(table, "chair", 2 + room.pick(5));
  }
  for (int i = room.pick(3); i > 0; --i)
    room.atWall(room.piece("bookcase"));
  if (room.chance(0.6))
    room.atWall(room.piece("floor_lamp"));
  for (int i = room.pick(3); i > 0; --i)
    room.atWall(room.piece("plant"));
}

void
furnishKitchen(RoomFurnisher& room)
{
  room.atWall(room.piece("kitchen_unit"));
  if (room.chance(0.5))
    room.atWall(room.piece("kitchen_unit"));
  if (room.chance(0.7)) {
    const int table =
        room.inTheMiddle(room.piece(room.chance(0.3) ? "round_table" : "table"), 0.7);
    room.around(table, room.chance(0.2) ? "stool" : "chair", 1 + room.pick(4));
  }
  if (room.chance(0.6))
    room.atWall(room.piece("bin"));
}

void
furnishBathroom(RoomFurnisher& room)
{
  room.atWall(room.piece("toilet"));
  room.atWall(room.piece("sink"));
  if (room.chance(0.4))
    room.atWall(room.piece("stool"));
}

void
furnishBedroom(RoomFurnisher& room)
{
  const int bed = room.atWall(room.piece("bed"));
  for (const int side : {-1, 1})
    if (room.chance(0.7))
      room.beside(bed, room.piece("drawers"), side, 0.02);
  for (int i = 1 + room.pick(2); i > 0; --i)
    room.atWall(room.piece("cabinet"));
  if (room.chance(0.5))
    room.atWall(room.piece("drawers"));
  if (room.chance(0.4))
    room.atWall(room.piece("chair"));
  if (room.chance(0.3))
    room.atWall(room.piece("plant"));
}

void
furnishStudy(RoomFurnisher& room)
{
  const int desk = room.atWall(room.piece("desk"));
  room.before(desk, room.piece("office_chair"), -0.1, 0, room.between(-0.5, 0.5));
  room.onTop(desk, room.piece("monitor"), 0, true);
  for (int i = 1 + room.pick(3); i > 0; --i)
    room.atWall(room.piece("bookcase"));
  if (room.chance(0.5))
    room.atWall(room.piece("drawers"));
}

void
furnishHall(RoomFurnisher& room)
{
  if (room.chance(0.5))
    room.atWall(room.piece("cabinet"));
  if (room.chance(0.4))
    room.atWall(room.piece("plant"));
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
  lightAndHeat(room);
}

} // namespace indoor
} // namespace pcl
