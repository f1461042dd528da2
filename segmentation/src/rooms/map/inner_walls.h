/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Divide rooms along walls that stand within them.
 *
 * A wall with the same room on both sides is the border of two rooms if it fills enough
 * of the straight line on which it goes on, across gaps, to other walls: a hallway that
 * opens wide to the living room beside it is a room of its own. Linear in pixels.
 *
 * \param[in,out] rooms room of each free pixel, 1 ... count; 0 = none
 * \param[in,out] count number of rooms; new ones get the next numbers
 * \param[in] directions of walls, any length but 0
 * \param[in] max_thickness of a wall, pixels
 * \param[in] min_share of the line that the wall fills, 0 ... 1
 * \param[in] min_area of each of the two rooms, pixels
 */
void
divideAtInnerWalls(PixelMap<std::int32_t>& rooms,
                   std::int32_t& count,
                   const std::vector<Eigen::Vector2d>& directions,
                   int max_thickness,
                   double min_share,
                   double min_area);

} // namespace pcl::indoor
