/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>
#include <pcl/indoor/exports.h>

#include <vector>

namespace pcl::indoor {

/** \brief Where an object is in its room; z is up, lengths are metres. */
struct ObjectPlace {
  bool is_known = false;       ///< nothing else counts if not
  float floor_distance = 0.0f; ///< of its lowest point from the floor
};

/** \brief Number of values that contextValues() gives. */
constexpr std::size_t context_value_count = 12;

/** \brief Size and place of an object as values for a classifier, each 0 or more.
 *
 * Size, of the upright box of the smallest footprint:
 * - 0 to 2: height, length and width (not longer than the length), metres, at most 4;
 * - 3 to 5: the same as ln(1 + metres / 0.1) / ln(31), which is 1 at 3 m;
 * - 6, 7: share of the points that face up or down (normal at most 30 degrees from z),
 *   and sideways (at most 30 degrees from the horizontal);
 * - 8: mean height of the points within the box, 0 ... 1.
 *
 * Place, all 0 if it is not known:
 * - 9: distance from the floor, metres, 0 ... 4;
 * - 10: 1 where that is below 0.1 m;
 * - 11: 1, the place is known.
 *
 * No points give a size of 0. Time: a few passes through the points.
 * \param[in] points finite, metres, z up
 */
PCL_INDOOR_EXPORTS std::vector<float>
contextValues(const std::vector<OrientedPoint>& points, const ObjectPlace& place);

/** \brief Sides of the smallest rectangle, turned anyhow, around points of the plane,
 * to about 1e-5 of its length.
 * \return length, and width that is not longer; zeros for no points
 */
PCL_INDOOR_EXPORTS Eigen::Vector2f
smallestRectangle(std::vector<Eigen::Vector2f> points);

} // namespace pcl::indoor
