/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief Sums over all rectangles that begin at (0, 0), for sums over any. */
class RectangleSums {
public:
  explicit RectangleSums(const PixelMap<float>& map)
  : nx_(map.nx)
  , ny_(map.ny)
  , sums_((map.nx + 1ul) * (map.ny + 1ul), 0.0)
  {
    for (int x = 0; x < nx_; ++x)
      for (int y = 0; y < ny_; ++y)
        at(x + 1, y + 1) = map.at(x, y) + at(x, y + 1) + at(x + 1, y) - at(x, y);
  }

  /** \brief The sum over a square of pixels around one, as far as it is in the map. */
  double
  around(int x, int y, int radius)
  {
    const int left = std::max(0, x - radius);
    const int right = std::min(nx_, x + radius + 1);
    const int low = std::max(0, y - radius);
    const int high = std::min(ny_, y + radius + 1);
    return at(right, high) - at(left, high) - at(right, low) + at(left, low);
  }

  double
  pixelsAround(int x, int y, int radius) const
  {
    const double across = std::min(nx_, x + radius + 1) - std::max(0, x - radius);
    return across * (std::min(ny_, y + radius + 1) - std::max(0, y - radius));
  }

private:
  double&
  at(int x, int y)
  {
    return sums_[static_cast<std::size_t>(x) * (ny_ + 1) + y];
  }

  int nx_;
  int ny_;
  std::vector<double> sums_;
};

} // namespace pcl::indoor
