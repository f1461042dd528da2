/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/building.h>

namespace pcl::indoor {

/** \brief A hole in the wall of one room. */
struct WallHole {
  int room = 0; ///< index into Building::rooms
  int edge = 0; ///< the edge that starts at this vertex of the room's polygon
  double s0 = 0.0, s1 = 0.0; ///< along the edge from that vertex, metres; lines of
                             ///< equal s lean with the wall
  double z0 = 0.0, z1 = 0.0; ///< height, metres
};

/** \brief An opening in the building: its frame, and the rooms at both sides. */
struct PlacedOpening {
  OpeningPlan plan;
  int storey = 0;
  Eigen::Vector3d origin;  ///< middle of the sill, in the middle of the wall
  Eigen::Vector2d along;   ///< unit vector, x of the opening's frame
  Eigen::Vector2d towards; ///< unit vector, y of the opening's frame, into front_room
  double lean = 0.0;       ///< metres towards per metre up
  int front_room = -1;     ///< index into Building::rooms
  int back_room = -1;      ///< -1: outside
};

struct WallHoles {
  std::vector<PlacedOpening> openings;
  std::vector<WallHole> holes;
};

/** \brief Find the walls of all openings of a plan.
 * \param[in] plan the plan
 * \param[in] rooms its rooms, in the order of the plan
 * \param[in] source what error messages call the plan
 * \throws PlanError if an opening lies in no wall, does not fit or meets another
 */
WallHoles
placeOpenings(const Plan& plan,
              const std::vector<RoomInfo>& rooms,
              const std::string& source);

} // namespace pcl::indoor
