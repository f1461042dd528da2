/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>
#include <pcl/segmentation/building_rooms_options.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Points of some rows of a map, pixel by pixel. */
struct PixelPoints {
  int begin_row = 0; ///< along x
  int end_row = 0;
  std::vector<std::uint32_t> first;     ///< per pixel of these rows, and the end
  std::vector<std::uint32_t> walls_end; ///< per pixel: its points at walls come first
  std::vector<Eigen::Vector2f> places;  ///< on the map: pixel (x, y) is [x, x + 1)
};

/** \brief Give each point at a wall the room that sees it.
 *
 * A pixel is often thicker than a wall, so the map alone cannot tell the two faces of a
 * wall apart. Around each pixel near a border between rooms, a vertical plane is fitted
 * to the points at walls and put between the wall's two faces (2-means along its
 * normal); each point of the pixel gets the room on its side.
 * \param[in] points of rows within the map
 * \param[in] pixel_size side of a pixel, metres
 * \param[in] labels room per pixel, 0 = none
 * \param[in] free_labels room per free pixel, 0 = wall or none
 * \param[in] threads 0 = automatic; the result does not depend on it
 * \param[in,out] point_labels room per point, in their order; changed where a wall
 * separates two rooms
 */
void
assignWallSides(const PixelPoints& points,
                double pixel_size,
                const PixelMap<std::int32_t>& labels,
                const PixelMap<std::int32_t>& free_labels,
                const WallSideOptions& options,
                int threads,
                std::vector<std::int32_t>& point_labels);

} // namespace pcl::indoor
