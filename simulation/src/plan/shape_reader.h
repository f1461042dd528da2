/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "plan/json_reader.h"

#include <cmath>

namespace pcl::indoor {

constexpr double radians_per_degree = M_PI / 180;

/** \brief Read a polygon, arcs included, and turn it counter-clockwise. */
Polygon
readPolygon(const JsonReader& json);

/** \brief Read a polygon and refuse one that is not convex. */
Polygon
readConvexPolygon(const JsonReader& json);

/** \brief Read a height, or a plane: {"height": h, "at": [x, y], "slope": [sx, sy]}. */
CeilingPlane
readPlane(const JsonReader& json);

/** \brief Read a ceiling: a plane, a ridge, a vault, or a list whose lowest counts. */
std::vector<CeilingPlane>
readCeiling(const JsonReader& json);

} // namespace pcl::indoor
