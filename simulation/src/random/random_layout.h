/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/plan.h>
#include <pcl/simulation/random_draw.h>

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace pcl::indoor {

/** \brief What a room of a random plan is for. */
enum class RoomKind {
  Hall,
  Living,
  Kitchen,
  Bathroom,
  Bedroom,
  Study,
  Office,
  Meeting,
  Storage
};

/** \brief A rectangular room: the middle lines of its walls, metres. */
struct LayoutRoom {
  Eigen::AlignedBox2d outline;
  RoomKind kind = RoomKind::Hall;
};

/** \brief A hole in a wall and the rooms that it joins; -1 is the outside. */
struct LayoutOpening {
  OpeningPlan plan;
  std::array<int, 2> rooms{-1, -1};
};

/** \brief Name of a kind of room, for example "living room". */
const char*
nameOf(RoomKind kind);

/** \brief What a room of a home or an office is for, in the words of plan files:
 * the bathroom of an office is a toilet. */
const char*
purposeOf(RoomKind kind, bool home);

/** \brief Rooms of a home, their kinds settled. At least four, one of them the hall. */
std::vector<LayoutRoom>
drawHomeRooms(RandomDraw& draw);

/** \brief The same rooms used as an upper floor: bedrooms, bathroom, study. */
std::vector<LayoutRoom>
asUpperFloor(std::vector<LayoutRoom> rooms, RandomDraw& draw);

/** \brief A corridor with rooms on both sides. */
std::vector<LayoutRoom>
drawOfficeRooms(RandomDraw& draw);

/** \brief True if doors can lead from the hall to every room. */
bool
canBeJoined(const std::vector<LayoutRoom>& rooms);

/** \brief Doors that join all rooms, passages and windows.
 * \param[in] rooms that can be joined
 * \param[in] ceiling height of the rooms, metres
 * \param[in] front_door whether there is a door to the outside
 */
std::vector<LayoutOpening>
drawOpenings(const std::vector<LayoutRoom>& rooms,
             double ceiling,
             bool front_door,
             RandomDraw& draw);

} // namespace pcl::indoor
