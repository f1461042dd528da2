/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/line_occupancy.h>

#include <algorithm>
#include <cassert>

namespace pcl::indoor {

LineOccupancy::LineOccupancy(const std::vector<OrientedPoint>& points, int grid_size)
{
  assert(!points.empty() && grid_size >= 2 && grid_size <= 64);
  Eigen::Array3f lower = points.front().position;
  Eigen::Array3f upper = lower;
  for (const auto& point : points) {
    lower = lower.min(point.position.array());
    upper = upper.max(point.position.array());
  }
  const float edge = (upper - lower).maxCoeff();
  origin_ = ((lower + upper - edge) / 2).matrix();
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
