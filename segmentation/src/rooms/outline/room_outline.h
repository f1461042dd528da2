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

/** \brief A closed line on the corners of pixels; the last point is joined to the
 * first. Pixel (x, y) covers x ... x + 1 and y ... y + 1. */
using OutlineRing = std::vector<Eigen::Vector2i>;

/** \brief Area within a ring, square pixels; negative if it runs clockwise. */
double
ringArea(const OutlineRing& ring);

/** \brief The same for corners anywhere. */
double
ringArea(const std::vector<Eigen::Vector2d>& ring);

/** \brief Trace the borders of all regions of a label map exactly.
 *
 * Pixels that touch at a corner only are not connected. Rings hold no point in the
 * middle of a straight line. Linear time and memory in pixels.
 * \param[in] labels 1 ... region_count; other values are no region
 * \param[in] region_count number of labels
 * \return per label (index 0 is empty) its rings: around its parts counter-clockwise,
 * around its holes clockwise, so that their signed areas sum up to its pixels; the ring
 * with the largest area first, then in the order of their first pixel
 */
std::vector<std::vector<OutlineRing>>
traceOutlines(const PixelMap<std::int32_t>& labels, std::int32_t region_count);

/** \brief Make a ring one of few corners (Douglas and Peucker, 1973).
 *
 * Each side is then fitted to the points it stands for, or the jagged borders of a
 * map would make rooms smaller.
 * \param[in] ring as traceOutlines() gives it
 * \param[in] tolerance how far a point that is left out may lie from the line between
 * those that stay, pixels (>= 0); the corners of a straight line at any angle lie
 * within sqrt(2) pixels
 * \return the ring as it is where the new one would cross itself or vanish
 */
std::vector<Eigen::Vector2d>
simplifyOutline(const OutlineRing& ring, double tolerance);

} // namespace pcl::indoor
