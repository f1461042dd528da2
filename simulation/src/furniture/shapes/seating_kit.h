/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "furniture/shapes/solids.h"

namespace pcl::indoor {

/** \brief What one sits on, leans on, rests arms on. */
enum class Seat { Board, Saddle, Round, Padded, Cushion, Thick };
enum class Back {
  None,
  Slats,
  Bars,
  Ladder,
  Board,
  Curved,
  Round,
  Mesh,
  Padded,
  Tufted
};
enum class Arms { None, Thin, Loop, Thick, Rounded, Wings };

/** \brief A seat, what carries it, what is leant on. */
struct Seating {
  Legs legs;
  Seat seat;
  Back back;
  Arms arms = Arms::None;
  double seat_share = 0.5; ///< height of the seat, of the whole
};

/** \brief The extent of a seat, and the heights of seat and back, metres. */
struct Frame {
  double x, y, rear, seat, top;
};

/** \brief Add the seat, what is leant on, and armrests. */
void
addSeat(PartMaker& make, Seat kind, const Frame& f);
void
addBack(PartMaker& make, Back kind, const Frame& f);
void
addArms(PartMaker& make, Arms kind, const Frame& f);

/** \brief A shape of a seat, back, legs and arms. */
FurnitureClass
seating(const char* name,
        const Size& smallest,
        const Size& largest,
        const Seating& style,
        int like = 0);

/** \brief A shape whose seat and back are one shell. */
FurnitureClass
shell(const char* name, const Size& smallest, const Size& largest, Legs carrier);

} // namespace pcl::indoor
