/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "room_tables.h"

#include <optional>

namespace pcl::indoor {

/** \brief What a room is like within its building; what is not known is not there. */
struct RoomTraits {
  std::optional<double> area;       ///< m^2
  std::optional<double> stretch;    ///< perimeter over that of the square of this area
  std::optional<bool> lit;          ///< has windows
  std::size_t ways = 0;             ///< to one room or none: 0, two: 1, more: 2
  std::optional<std::size_t> level; ///< 0 = cellar, 1 = entrance, 2 = above it
  std::optional<bool> largest;      ///< of the four rooms or more that can be reached
  bool tall = false;                ///< much higher than most rooms
  bool may_have_stairs = false;     ///< there are storeys, or it is tall
  bool furnished = false;           ///< some objects in it are known
  std::array<double, object_count> seen{}; ///< probability that it holds each object
};

/** \brief All of a building. */
struct BuildingTraits {
  std::vector<RoomTraits> rooms;
  std::array<bool, 3> levels{};     ///< which there are
  std::optional<double> floor_area; ///< that can be reached on a storey, m^2
};

/** \brief Traits of rooms that nameRooms() accepts. */
BuildingTraits
buildingTraits(const std::vector<RoomEvidence>& rooms);

} // namespace pcl::indoor
