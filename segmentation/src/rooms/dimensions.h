/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

namespace pcl::indoor {

/** \file Dimensions of people, buildings and scans that several steps go by, metres,
 * square metres and radians. */

constexpr double standing_height = 1.5; ///< nobody stands where less is free, and most
                                        ///< furniture is lower
constexpr double passage_height = 1.6;  ///< lower openings let nobody pass, and most
                                        ///< shelves end below
constexpr double sill_height = 0.3;     ///< what is lower is part of floors
constexpr double thickest_wall = 0.5; ///< of those between rooms; slabs are no thicker
constexpr double steepest_lean = 0.5; ///< of walls, radians from the vertical; what
                                      ///< leans more is a roof
constexpr double lintel_height = 0.2; ///< over doorways, at least
constexpr double least_room = 4.0;    ///< area of a room: niches and furniture are
                                      ///< smaller
constexpr double crowd = 0.04;        ///< two standard deviations of a scanner's noise:
                                      ///< over this the points of one face scatter
constexpr double surroundings = 1.0;  ///< of a place: wider than a stair's landing,
                                      ///< deeper than a cupboard

} // namespace pcl::indoor
