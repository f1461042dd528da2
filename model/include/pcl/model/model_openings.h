/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/model/building_model.h>
#include <pcl/model/model_walls.h>
#include <pcl/model/wall_holes.h>

#include <vector>

namespace pcl::indoor {

/** \brief What the image of a wall's side shows. */
using FaceHoles = std::vector<FaceHole>;

/** \brief Say which holes are doors and windows.
 *
 * A door reaches the floor and is as high and wide as a person needs; a window stands
 * above the floor and below the ceiling. The wall's face frames both; where glass, a
 * leaf or a reveal is seen, one of the upright edges may be a corner of the room. In a
 * wall between two rooms a window, or a door that stands open, is one only if both
 * sides show it; a niche is none. Of two sides that show one opening the better framed
 * one measures it.
 * \param[in] holes per side
 * \param[in] passable where one can pass; each is an opening, whether or not its edges
 * are seen in the images
 * \return those of \a passable in their order, then all others, storey by storey;
 * without their walls
 */
PCL_INDOOR_EXPORTS std::vector<ModelOpening>
modelOpenings(const std::vector<WallFace>& faces,
              const std::vector<FacePair>& pairs,
              const std::vector<FaceHoles>& holes,
              const std::vector<RoomOpening>& passable);

} // namespace pcl::indoor
