/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/line_occupancy.h>

#include <algorithm>
#include <cassert>

namespace pcl {
namespace indoor {

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

LineOccupancy::Cell
LineOccupancy::cell(const Eigen::Vector3f& position) const
{
  const Eigen::Array3f place = ((position - origin_) * inverse_voxel_size_).array();
  const Eigen::Array3f inside = place.max(0.0f).min(largest_coordinate_);
  // A little below the middle: where a line passes exactly between two voxels it then
  // goes through the lower one, however its step was rounded. The 63 roundings of a
  // line add up to less than this, and any other place is farther than 1 / 126 from a
  // border.
  constexpr Cell center = (Cell{1} << (fraction_bits - 1)) - 64;
  const auto field = [&](int axis, int bits) {
    const Cell voxel = static_cast<Cell>(inside[axis]);
    return ((voxel << fraction_bits) + center) << bits;
  };
  return field(0, 42) | field(1, 21) | field(2, 0);
}

} // namespace indoor
} // namespace pcl
