/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/model/model_walls.h>

#include <vector>

namespace pcl::indoor {

constexpr double least_wall = 0.2; // metres: shorter ones are none
constexpr double crossing = 0.5;   // metres: what crosses a wall is no thicker

/** \brief Length of a wall, metres. */
inline double
lengthOf(const ModelWall& wall)
{
  return (wall.end - wall.begin).norm();
}

/** \brief A wall, or a piece of one. */
struct WallPiece {
  ModelWall wall;
  double two_sided = 0.0; ///< how much of its length was seen from both sides, metres
  double depth = 0.0; ///< of one with one side: how far behind it windows are, metres
};

/** \brief Of each pair of sides a piece with a thickness, and of what has no partner
 * one with one side.
 * \param[in] depths of the windows in each side, metres */
std::vector<WallPiece>
wallPieces(const std::vector<WallFace>& faces,
           const std::vector<FacePair>& pairs,
           const std::vector<double>& depths);

/** \brief Join pieces to walls: those on one line, of one thickness, with no more than
 * a crossing wall between them.
 *
 * A piece with one side goes on a wall with two where it is shorter than what was seen
 * of that from both sides and lies on one of its sides.
 * \return walls, those with two
 * sides first, the longest first
 */
std::vector<WallPiece>
joinedPieces(std::vector<WallPiece> pieces);

} // namespace pcl::indoor
