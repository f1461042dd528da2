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

namespace pcl {
namespace indoor {

/** \brief Give each point at a wall the room that sees it.
 *
 * A pixel is often thicker than a wall, so the map alone cannot tell the two faces of a
 * wall apart. Around each pixel near a border between rooms, a vertical plane is fitted
 * to the points of the wall and put between its two faces (2-means along its normal);
 * each point of the pixel gets the room on its side.
 * \param[in] points positions in the frame of the map, metres: pixel (x, y) covers
 * [x, x + 1) * pixel_size
 * \param[in] is_wall per point, non-zero: the plane is fitted to it
 * \param[in] pixel_size side of a pixel, metres
 * \param[in] labels room per pixel, 0 = none
 * \param[in] free_labels room per free pixel, 0 = wall or none
 * \param[in,out] point_labels room per point; changed where a wall separates two rooms
 */
void
assignWallSides(const std::vector<Eigen::Vector2f>& points,
                const std::vector<std::uint8_t>& is_wall,
                double pixel_size,
                const PixelMap<std::int32_t>& labels,
                const PixelMap<std::int32_t>& free_labels,
                const WallSideOptions& options,
                std::vector<std::int32_t>& point_labels);

} // namespace indoor
} // namespace pcl
