/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "building/room_shell.h"

namespace pcl::indoor {

/** \brief Find the rooms above and below each hole in a floor.
 * \throws PlanError if there is none, or if the ceiling below has an edge there
 */
std::vector<WellInfo>
placeWells(const Plan& plan,
           const std::vector<RoomInfo>& rooms,
           const std::string& source);

/** \brief Find the room of each platform.
 * \throws PlanError if there is none, or if it reaches below its floor or above its
 * ceiling
 */
std::vector<PlatformInfo>
placePlatforms(const Plan& plan,
               const std::vector<RoomInfo>& rooms,
               const std::string& source);

/** \brief The upper or lower half of the faces around a hole in a floor. */
std::vector<ShellPiece>
wellReveal(const Building& building, const WellInfo& well, bool upper);

/** \brief Top, sides and, of a slab, the bottom. */
std::vector<ShellPiece>
platformShell(const Building& building, const PlatformInfo& platform);

} // namespace pcl::indoor
