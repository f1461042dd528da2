/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "random/random_layout.h"

#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief Where belongings are with respect to a piece of furniture. */
enum class Where {
  On,     ///< on top
  In,     ///< on any of its boards
  Seat,   ///< on something soft, of which objects lean on the back
  Below,  ///< on the floor between its legs
  Over,   ///< cloth across it
  Back,   ///< cloth over the back of a chair
  Around, ///< on the floor beside it
};

/** \brief What is usually found on which pieces, and how many of it on one of them. */
struct Habit {
  std::vector<std::string> pieces;
  Where where;
  double expected;
  const char* object;
  int first, last; ///< its shapes
};

/** \brief What lies or stands on the floor, leans on walls and hangs there: how many of
 * it in one room. */
struct Custom {
  RoomKind room;
  double expected;
  const char* object;
  int first, last;
  double elevation; ///< on a wall; -1 anywhere on the floor, 0 at the foot of a wall
};

/** \brief On and below tables and what else one works at. */
std::vector<Habit>
tableHabits();

/** \brief On what one sits and lies on. */
std::vector<Habit>
seatHabits();

/** \brief On and in storage, kitchens, baths. */
std::vector<Habit>
storageHabits();

/** \brief On floors and walls. */
std::vector<Custom>
customs();

} // namespace pcl::indoor
