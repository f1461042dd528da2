/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/scan_sample.h"

#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief Objects that stand at the ends of the free space of rooms.
 *
 * Where one end of the space is nearer to the middle than beside it, is level as far as
 * furniture is wide, and the other end stays where it is, an object stands on the first
 * end. Lintels are narrower, pitched roofs are not level.
 */
struct ObjectsAtEnds {
  int low = 0, high = 0;   ///< columns at the sides of objects
  std::size_t columns = 0; ///< of rooms

  ObjectsAtEnds&
  operator+=(const ObjectsAtEnds& other);

  /** \brief There is furniture, and most of it at one end: -1 = low, 1 = high; else 0.
   * \param[in] times as much as at the other end, at least
   */
  int
  clearEnd(double times = 1.5) const;
};

/** \param[in] space along a direction that is the vertical or points down */
ObjectsAtEnds
objectsAtEnds(const FreeSpace& space);

} // namespace pcl::indoor
