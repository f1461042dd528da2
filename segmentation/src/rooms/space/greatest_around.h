/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/voxel_map.h>

namespace pcl::indoor {

/** \brief The greatest value within a square around each pixel, as far as it is in the
 * map: three comparisons per pixel and axis, whatever the radius.
 * \param[in] radius pixels along x and y (>= 0)
 */
PixelMap<int>
greatestAround(PixelMap<int> map, int radius);

} // namespace pcl::indoor
