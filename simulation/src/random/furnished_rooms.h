/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "random/room_furnisher.h"

namespace pcl::indoor {

/** \brief Put the furniture of its kind into a room. */
void
furnishHomeRoom(RoomFurnisher& room, RoomKind kind);
void
furnishOfficeRoom(RoomFurnisher& room, RoomKind kind);

/** \brief Add what people leave in a furnished room: objects on, in, under and over its
 * furniture, on its floor and on its walls. */
void
addBelongings(RoomFurnisher& room, RoomKind kind);

} // namespace pcl::indoor
