/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>
#include <pcl/indoor/exports.h>

#include <vector>

namespace pcl::indoor {

/** \brief Number of values that uprightProfile() gives. */
constexpr std::size_t upright_profile_size = 80;

/** \brief What an object that stands upright has at which height, as shares of its
 * points.
 *
 * Level points have a normal at most 37 degrees from the vertical.
 * - 18 bins of the height above the floor, of level points: a seat, a table's top;
 * - the same of all other points;
 * - 8 bins of the height within the object, of level points, and of others;
 * - 6 bins of the distance from the vertical axis through the centroid, over the
 *   largest one, of level points, and of others;
 * - 4 x 4 bins of height within the object and distance from the axis, of all points.
 *
 * The heights above the floor end at 0.1, 0.2 ... 1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.3 and
 * 2.7 m and above.
 * \param[in] points finite, metres, z up; none give zeros
 * \param[in] floor_distance of the lowest point from the floor, metres
 */
PCL_INDOOR_EXPORTS std::vector<float>
uprightProfile(const std::vector<OrientedPoint>& points, float floor_distance);

} // namespace pcl::indoor
