/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "random/furnished_rooms.h"

#include <algorithm>

namespace pcl::indoor {

namespace {

void
furnishOffice(RoomFurnisher& room)
{
  const int places = 1 + static_cast<int>(room.size().prod() / 9.0);
  for (int i = 0; i < places; ++i)
    room.workplace(
        room.piece(room.chance(0.8) ? "desk" : "table"), "office_chair", 0.3);
  for (int i = 1 + room.pick(3); i > 0; --i)
    room.atWall(room.piece(room.chance(0.5) ? "bookcase" : "cabinet"));
  if (room.chance(0.4))
    room.putSmallObjects(room.atWall(room.piece("drawers")), 2);
  room.perhapsAtWall(0.25, "rack");
  if (room.chance(0.4))
    room.onWall(room.piece("board"), 0.9);
  room.perhapsAtWall(0.2, "sofa");
  room.severalAtWall(2, "chair");
  room.perhapsAtWall(0.6, "bin");
  room.perhapsAtWall(0.3, "coat_rack");
  if (room.chance(0.3))
    room.anywhere(room.piece("person"));
  if (room.chance(0.3))
    room.onWall(room.shaped("air_conditioner", 0, 0), 1.9);
}

void
furnishMeeting(RoomFurnisher& room)
{
  const double length = std::min(room.between(1.8, 3.2), room.size().maxCoeff() - 1.8);
  const double width = std::min(room.between(0.9, 1.3), room.size().minCoeff() - 1.8);
  if (width > 0.7) {
    const int table = room.inTheMiddle(
        room.piece("table", Eigen::Vector3d(length, width, 0.74)), 0.1);
    room.around(table, room.chance(0.5) ? "chair" : "office_chair", 12);
    room.putSmallObjects(table, room.pick(6));
    for (int i = room.pick(3); i > 0; --i) {
      const double turn = room.between(-3.0, 3.0);
      room.onTop(table, room.piece("laptop"), turn);
    }
  }
  room.onWall(room.piece("board"), 0.9);
  if (room.chance(0.6))
    room.onWall(room.shaped("tv", 1, 1), 1.0);
  if (room.chance(0.5))
    room.putSmallObjects(room.atWall(room.piece("cabinet")), 2);
}

void
furnishKitchenette(RoomFurnisher& room)
{
  room.kitchenRow(1 + room.pick(4));
  const int table =
      room.inTheMiddle(room.piece(room.chance(0.6) ? "round_table" : "table"), 0.6);
  room.around(table, room.chance(0.3) ? "stool" : "chair", 4);
  room.putSmallObjects(table, room.pick(4));
  room.perhapsAtWall(0.3, "sofa");
  room.perhapsAtWall(0.7, "bin");
}

void
furnishStorage(RoomFurnisher& room)
{
  for (int i = 2 + room.pick(4); i > 0; --i)
    room.atWall(room.piece(room.chance(0.7) ? "rack" : "cabinet"));
  for (int i = room.pick(6); i > 0; --i) {
    const int box = room.atWall(room.piece("box"));
    if (room.chance(0.4))
      room.onTop(box, room.piece("box"));
  }
}

void
furnishToilets(RoomFurnisher& room)
{
  for (int i = 1 + room.pick(2); i > 0; --i)
    room.atWall(room.piece("toilet"));
  for (int i = 1 + room.pick(2); i > 0; --i)
    room.atWall(room.shaped("sink", 0, 1));
  room.atWall(room.piece("bin"));
}

void
furnishCorridor(RoomFurnisher& room)
{
  for (int i = room.pick(4); i > 0; --i)
    room.atWall(room.piece(room.chance(0.5) ? "cabinet" : "chair"));
  if (room.chance(0.5))
    room.atWall(room.piece("printer", Eigen::Vector3d(0.6, 0.6, 1.1)));
  room.perhapsAtWall(0.4, "bench");
  if (room.chance(0.3))
    room.anywhere(room.piece("person"));
}

} // namespace

void
furnishOfficeRoom(RoomFurnisher& room, RoomKind kind)
{
  switch (kind) {
  case RoomKind::Meeting:
    furnishMeeting(room);
    break;
  case RoomKind::Kitchen:
    furnishKitchenette(room);
    break;
  case RoomKind::Storage:
    furnishStorage(room);
    break;
  case RoomKind::Bathroom:
    furnishToilets(room);
    break;
  case RoomKind::Hall:
    furnishCorridor(room);
    break;
  default:
    furnishOffice(room);
  }
  room.radiatorsBelowWindows();
  const Piece lamp = room.chance(0.7) ? room.shaped("ceiling_lamp", 0, 0)
                                      : room.shaped("ceiling_lamp", 1, 3);
  for (int i = static_cast<int>(room.size().prod() / 8.0); i >= 0; --i)
    room.fromCeiling(lamp);
  room.severalAtWall(2, "plant");
  for (int i = room.pick(3); i > 0; --i)
    room.hang("picture", 1.1, 1.5);
  for (int i = room.pick(3); i > 0; --i)
    room.anywhere(room.piece("box"));
}

} // namespace pcl::indoor
