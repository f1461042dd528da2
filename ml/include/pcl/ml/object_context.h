/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>

#include <vector>

namespace pcl {
namespace indoor {

/** \brief Where an object is in its room; z is up, lengths are metres. */
struct ObjectPlace {
  bool is_known = false;         ///< nothing else counts if not
  float floor_distance = 0.0f;   ///< of its lowest point from the floor
  float ceiling_distance = 0.0f; ///< of its highest point from the ceiling
  float wall_distance = 0.0f;    ///< of its nearest point from the nearest wall
};

/** \brief Number of values that contextValues() gives. */
constexpr std::size_t context_value_count = 16;

/** \brief Size and place of an object as values for a classifier, each about 0 to 1.
 *
 * Size: height and, of the upright box that is turned to the smallest footprint, length
 * and width; each in metres and as logarithm; what share of the points faces up and
 * sideways; the mean height of points within the object. Place: distances from floor,
 * ceiling and wall, and whether they are below 0.1 m; all 0 if the place is not known,
 * which is the last value. \param[in] points metres, z up
 */
std::vector<float>
contextValues(const std::vector<OrientedPoint>& points, const ObjectPlace& place);

} // namespace indoor
} // namespace pcl
