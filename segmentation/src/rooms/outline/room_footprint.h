/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/outline/wall_points.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace pcl::indoor {

/** \brief What the sides of a footprint are moved to. */
struct FootprintWalls {
  WallPoints walls;  ///< points of what stands from the floor up to the ceiling, pixels
  WallPoints others; ///< all points that closed the room, pixels
  double reach = 10.0; ///< how far walls are prolonged behind what hangs, pixels
  /** Whether the room may grow by a part of the map; empty: it never does. */
  std::function<bool(const std::vector<Eigen::Vector2d>& part)> may_cover;
};

/** \brief Move the sides of a ring to the faces of the walls behind them.
 *
 * A side of the ring lies up to a pixel before the wall. It is moved and turned to the
 * first face within 2 pixels behind it: of a wall or, where there is none, of whatever
 * closed the room. It stays where there is less than a point per pixel, as in doorways.
 *
 * Sides at cupboards and beams, which are no walls, are left out if the walls before
 * and after them meet behind them or are the same wall. Holes without any wall, such as
 * those around lamps, are left out as a whole.
 * \param[in] ring corners, pixels; the region is on the left
 * \param[in] behind what was seen behind its sides
 * \return the ring as it is where the new one would turn over or vanish; nothing for a
 * hole that is none
 */
std::vector<Eigen::Vector2d>
moveToWalls(const std::vector<Eigen::Vector2d>& ring, const FootprintWalls& behind);

} // namespace pcl::indoor
