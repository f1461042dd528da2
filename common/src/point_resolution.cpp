/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/indoor/point_resolution.h>

#include <pcl/indoor/quantile.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace {

constexpr std::size_t sample_count = 2000;

/** The same point whatever the order of the input. */
std::uint32_t
firstPoint(const std::vector<Eigen::Vector3f>& points,
           const pcl::indoor::PointCells& cells,
           std::uint32_t cell)
{
  const auto key = [&](std::uint32_t i) {
    return std::make_tuple(points[i].x(), points[i].y(), points[i].z());
  };
  const auto inside = cells.pointsOf(cell);
  return *std::min_element(
      inside.begin(), inside.end(), [&](auto a, auto b) { return key(a) < key(b); });
}

} // namespace

namespace pcl {
namespace indoor {

double
medianResolution(const std::vector<Eigen::Vector3f>& points, const PointCells& cells)
{
  const auto around = cellAdjacency(cells.keys);
  const auto stride = std::max<std::size_t>(1, cells.size() / sample_count);
  std::vector<double> distances;
  for (std::size_t c = 0; c < cells.size(); c += stride) {
    const auto cell = static_cast<std::uint32_t>(c);
    const auto query = firstPoint(points, cells, cell);
    float nearest = std::numeric_limits<float>::infinity();
    const auto visit = [&](std::uint32_t other_cell) {
      for (const auto point : cells.pointsOf(other_cell))
        if (point != query)
          nearest = std::min(nearest, (points[point] - points[query]).squaredNorm());
    };
    visit(cell);
    for (const auto other : around.of(cell))
      visit(other);
    distances.push_back(std::sqrt(nearest));
  }
  if (distances.empty())
    return std::numeric_limits<double>::infinity();
  return median(distances);
}

double
raisedToResolution(const std::vector<Eigen::Vector3f>& points, double voxel_size)
{
  constexpr double factor = 2.5; // Eq. (2.9)
  constexpr int most_doublings = 12;
  double cell_size = voxel_size;
  for (int i = 0; i < most_doublings && points.size() > 1; ++i, cell_size *= 2) {
    const auto resolution = medianResolution(points, groupByCell(points, cell_size));
    if (std::isfinite(resolution))
      return std::max(voxel_size, factor * resolution);
  }
  return voxel_size;
}

} // namespace indoor
} // namespace pcl
