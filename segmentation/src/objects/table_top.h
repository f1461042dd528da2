/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>

namespace pcl::indoor {

constexpr std::size_t fewest_points_of_table = 1000; ///< that tell what stands on it
constexpr float widest_table = 1.5f;                 ///< metres: less than rooms have

} // namespace pcl::indoor
