/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "point_spacing.h"

#include <pcl/common/point_tests.h> // for isFinite

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pcl::indoor::tool {
namespace {

/** The number of points in the median of the occupied cells. */
std::size_t
medianCount(const std::vector<Eigen::Vector3f>& points, double cell_size)
{
  using Cell = std::array<std::int64_t, 3>;
  std::vector<Cell> cells;
  cells.reserve(points.size());
  for (const auto& point : points) {
    const Eigen::Vector3d scaled = point.cast<double>() / cell_size;
    // far outliers share the cells at the end
    const auto index = [](double value) {
      return static_cast<std::int64_t>(std::floor(std::clamp(value, -1e15, 1e15)));
    };
    cells.push_back({index(scaled.x()), index(scaled.y()), index(scaled.z())});
  }
  std::sort(cells.begin(), cells.end());
  std::vector<std::size_t> counts;
  for (std::size_t begin = 0, end = 0; begin < cells.size(); begin = end) {
    while (end < cells.size() && cells[end] == cells[begin])
      ++end;
    counts.push_back(end - begin);
  }
  const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
  std::nth_element(counts.begin(), middle, counts.end());
  return *middle;
}

} // namespace

double
pointSpacing(const PointCloud<PointXYZ>& points)
{
  std::vector<Eigen::Vector3f> finite;
  for (const auto& point : points)
    if (isFinite(point))
      finite.push_back(point.getVector3fMap());
  if (finite.size() < 2)
    return 0.0;
  constexpr std::size_t several =
      6;                   // points per cell: the count's noise is below a half
  double cell_size = 0.02; // metres
  std::size_t count = medianCount(finite, cell_size);
  while (count < several && cell_size < 1e4) {
    cell_size *= 1.5;
    count = medianCount(finite, cell_size);
  }
  // the surface in a cell is about as large as the cell's side
  return cell_size / std::sqrt(static_cast<double>(count));
}

} // namespace pcl::indoor::tool
