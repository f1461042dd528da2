/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "room_furnisher.h"

namespace pcl {
namespace indoor {

namespace {

void
workplace(RoomFurnisher& room)
{
  const Piece desk_piece = room.piece(room.chance(0.7) ? "desk" : "table");
  const int desk =
      room.chance(0.7) ? room.atWall(desk_piece) : room.inTheMiddle(desk_piece, 0.7);
  if (desk < 0)
    return;
  room.before(desk,
              room.piece("office_chair"),
              room.between(-0.15, 0.1),
              room.between(-0.2, 0.2),
              room.between(-0.8, 0.8));
  for (int i = 1 + room.pick(2); i > 0; --i)
    room.onTop(desk, room.piece("monitor"), room.between(-0.2, 0.2), true);
  if (room.chance(0.5))
    room.beside(desk, room.piece("drawers"), room.chance(0.5) ? 1 : -1, 0.02);
}

void
furnishOffice(RoomFurnisher& room)
{
  const int places = 1 + static_cast<int>(room.size().prod() / 9.0);
  for (int i = 0; i < places; ++i)
    workplace(room);
  for (int i = 1 + room.pick(3); i > 0; --i)
    room.atWall(room.piece(room.chance(0.5) ? "bookcase" : "cabinet"));
  if (room.chance(0.5))
    room.atWall(room.piece("board"), 0.9);
  if (room.chance(0.6))
    room.atWall(room.piece("bin"));
  if (room.chance(0.4))
    room.atWall(room.piece("plant"));
}

void
furnishMeeting(RoomFurnisher& room)
{
  const double length = std::min(room.between(1.8, 3.2), room.size().maxCoeff() - 1.8);
  const double width = std::min(room.between(0.9, 1.3), room.size().minCoeff() - 1.8);
  if (width > 0.7) {
    const int table = room.inTheMiddle(
        room.piece("table", Eigen::Vector3d(length, width, 0.74)), 0.1);
    room.around(table, room.chance(0.5) ? "chair" : "office_chair", 10);
  }
  room.atWall(room.piece("board"), 0.9);
  if (room.chance(0.5))
    room.atWall(room.piece("cabinet"));
  if (room.chance(0.5))
    room.atWall(room.piece("plant"));
}

void
furnishKitchenette(RoomFurnisher& room)
{
  room.atWall(room.piece("kitchen_unit"));
  const int table = room.inTheMiddle(room.piece("round_table"), 0.6);
  room.around(table, room.chance(0.4) ? "stool" : "chair", 4);
  if (room.chance(0.7))
    room.atWall(room.piece("bin"));
}

void
furnishStorage(RoomFurnisher& room)
{
  for (int i = 2 + room.pick(4); i > 0; --i)
    room.atWall(room.piece("rack"));
}

void
furnishToilets(RoomFurnisher& room)
{
  for (int i = 1 + room.pick(2); i > 0; --i)
    room.atWall(room.piece("toilet"));
  for (int i = 1 + room.pick(2); i > 0; --i)
    room.atWall(room.piece("sink"));
  room.atWall(room.piece("bin"));
}

void
furnishCorridor(RoomFurnisher& room)
{
  for (int i = room.pick(3); i > 0; --i)
    room.atWall(room.piece("plant"));
  for (int i = room.pick(3); i > 0; --i)
    room.atWall(room.piece(room.chance(0.5) ? "cabinet" : "chair"));
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
  room.belowWindows("radiator", 0.6);
  for (int i = static_cast<int>(room.size().prod() / 8.0); i >= 0; --i)
    room.fromCeiling(room.piece("ceiling_lamp"));
}

} // namespace indoor
} // namespace pcl
