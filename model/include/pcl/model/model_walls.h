/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/model/building_model.h>

#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief A stretch of two sides that face away from each other: both sides of a wall.
 */
struct FacePair {
  std::size_t face = 0, other = 0; ///< the other lies behind it
  double from = 0.0, to = 0.0;     ///< where they overlap, along the face, metres
  double gap = 0.0;                ///< thickness of the wall, metres
};

/** \brief Find the pairs of sides of walls, each from both sides.
 *
 * A side's partner is the nearest one behind it, at most 0.7 m away.
 */
PCL_INDOOR_EXPORTS std::vector<FacePair>
facePairs(const std::vector<WallFace>& faces);

/** \brief Make walls of sides and their pairs: of each pair one, of each rest of a side
 * one with one side. Pieces on one line, of one thickness, with no more than a crossing
 * wall between them are one wall; a rest of a side is part of a longer wall on one side
 * of which it lies. Walls end on the axes of walls that they meet. The axis of a wall
 * with one side is not known, but it is not nearer to this side than half of the depth
 * of its windows; a wall with two sides goes on to there.
 * \param[in] depths per side, how far behind it the windows and outer doors in it are,
 * metres; 0 = not known; sides without any are as those of their storey; none at all =
 * none is known
 */
PCL_INDOOR_EXPORTS std::vector<ModelWall>
modelWalls(const std::vector<WallFace>& faces,
           const std::vector<FacePair>& pairs,
           const std::vector<double>& depths = {});

} // namespace pcl::indoor
