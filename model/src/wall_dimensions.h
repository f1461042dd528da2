/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>

namespace pcl::indoor {

/** \file Dimensions of walls and scans that several steps go by, metres. */

constexpr double thickest_old_wall = 0.7; ///< of all: inner walls of today are thinner
constexpr double half_thickest = 0.5 * thickest_old_wall; ///< from an axis to a side
constexpr double opening_reach = half_thickest + 0.15; ///< from an opening to the axis
                                                       ///< or a side of its wall: and a
                                                       ///< voxel of rooms
constexpr double scanner_noise = 0.02;             ///< two standard deviations, one way
constexpr double noise_band = 2.0 * scanner_noise; ///< both ways: what shows one side
constexpr double same_line = 0.05;        ///< apart: steps between walls are larger
constexpr double flat_corner = 0.3;       ///< sine, 17 degrees: flatter walls meet
                                          ///< anywhere
constexpr std::size_t enough_points = 20; ///< or a side or a column is not seen

} // namespace pcl::indoor
