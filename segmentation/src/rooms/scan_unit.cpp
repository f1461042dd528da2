/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/scan_overview.h>

#include <cmath>
#include <initializer_list>

namespace pcl::indoor {

double
likelyMetresPerUnit(double length)
{
  constexpr double room_height = 2.5; // metres
  double best = 1.0;
  for (const double unit : {1.0, 0.3048, 0.0254, 0.01, 0.001})
    if (std::abs(std::log(length * unit / room_height)) <
        std::abs(std::log(length * best / room_height)))
      best = unit;
  return best;
}

} // namespace pcl::indoor
