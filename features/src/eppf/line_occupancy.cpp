/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/line_occupancy.h>

#include "internal/point_bounds.h"

#include <algorithm>
#include <cassert>

namespace pcl::indoor {

LineOccupancy::LineOccupancy(const std::vector<OrientedPoint>& points, int grid_size)
{
  assert(!points.empty() && grid_size >= 2 && grid_size <= 64);
  const auto bounds = boundsOf(points);
  const float edge = bounds.sizes().maxCoeff();
  origin_ = ((bounds.min() + bounds.max()).array() - edge) / 2;
  inverse_voxel_size_ = edge > 0.0f ? static_cast<float>(grid_size) / edge : 0.0f;
  largest_coordinate_ = static_cast<float>(grid_size - 1);
  for (int steps = 0; steps < 64; ++steps)
    reciprocals_[steps] = (1 << 30) / std::max(steps, 1);
  for (const auto& point : points) {
    const Cell occupied = cell(point.position);
    rows_[row(occupied)] |= std::uint64_t{1} << column(occupied);
  }
}

} // namespace pcl::indoor
