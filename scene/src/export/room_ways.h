/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/plan_polygon.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The shortest ways between places of a room. */
struct RoomWays {
  std::vector<Eigen::Vector2d> points; ///< the given places, then corners to pass
  std::vector<std::pair<std::size_t, std::size_t>> lines; ///< between two points each
};

/** \brief Is all of a line inside rings?
 *
 * It may touch their sides. */
bool
seesEachOther(const std::vector<PlanRing>& rings,
              const Eigen::Vector2d& a,
              const Eigen::Vector2d& b);

/** \brief Find the shortest ways between all pairs of places.
 *
 * They are straight, or turn at corners of the room, from which they keep away where
 * there is space. Time: corners^2 * sides.
 * \param[in] rings of the room: counter-clockwise, holes not
 * \param[in] places in the room; those that have no way to others are joined to the
 * first by a straight line
 * \param[in] clearance from corners, metres
 */
RoomWays
roomWays(const std::vector<PlanRing>& rings,
         const std::vector<Eigen::Vector2d>& places,
         double clearance);

} // namespace pcl::indoor::tool
