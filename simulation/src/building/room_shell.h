/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "building/wall_holes.h"

namespace pcl::indoor {

/** \brief A flat piece of a room's shell. */
struct ShellPiece {
  Triangle triangle; ///< its normal points into the room
  enum class Face { Floor, Wall, Ceiling } face;
};

/** \brief What is left out of a shell. */
struct ShellHoles {
  std::vector<WallHole> walls;
  std::vector<Polygon> floor, ceiling; ///< convex, counter-clockwise
};

/** \brief Add a convex, flat face whose corners run around its normal. */
void
addFace(std::vector<ShellPiece>& pieces,
        ShellPiece::Face face,
        const std::vector<Eigen::Vector3d>& corners);

/** \brief Floor, ceiling and walls of a room, with its holes left out. */
std::vector<ShellPiece>
roomShell(const RoomInfo& room, const ShellHoles& holes);

/** \brief The inner faces of a hole on one side of the middle of the wall.
 * \param[in] opening the opening
 * \param[in] y where the wall ends, in the opening's frame; its sign says which side
 */
std::vector<ShellPiece>
reveal(const PlacedOpening& opening, double y);

/** \brief The upright faces where one part of a ceiling is higher than the next. */
std::vector<ShellPiece>
ceilingSteps(const RoomInfo& room);

} // namespace pcl::indoor
