/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/building.h>

namespace pcl::indoor {

/** \brief The plane of a wall's inner face: s along it on the floor, z up.
 *
 * Where the wall leans, lines of equal s lean with it. The corners at its ends lean as
 * the neighbouring walls want it: the wall spans first(z) <= s <= last(z).
 */
struct WallFrame {
  Eigen::Vector2d start, along, inwards;      ///< its beginning; unit vectors
  double floor = 0.0, length = 0.0;           ///< metres
  double lean = 0.0;                          ///< metres inwards per metre up
  double first_drift = 0.0, last_drift = 0.0; ///< of its ends, along it, per metre up

  Eigen::Vector2d
  at(double s, double z) const
  {
    return start + s * along + (z - floor) * lean * inwards;
  }

  double
  first(double z) const
  {
    return (z - floor) * first_drift;
  }

  double
  last(double z) const
  {
    return length + (z - floor) * last_drift;
  }
};

inline WallFrame
wallFrame(const RoomInfo& room, std::size_t edge)
{
  const std::size_t next = (edge + 1) % room.polygon.size();
  const Eigen::Vector2d way = room.polygon[next] - room.polygon[edge];
  WallFrame frame;
  frame.start = room.polygon[edge];
  frame.length = way.norm();
  frame.along = way / frame.length;
  frame.inwards = Eigen::Vector2d(-frame.along.y(), frame.along.x());
  frame.floor = room.floor;
  frame.lean = room.drift[edge].dot(frame.inwards);
  frame.first_drift = room.drift[edge].dot(frame.along);
  frame.last_drift = room.drift[next].dot(frame.along);
  return frame;
}

} // namespace pcl::indoor
