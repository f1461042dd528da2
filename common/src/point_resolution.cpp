/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/indoor/point_resolution.h>

#include <pcl/indoor/neighbor_distance.h> // for closest_neighbors
#include <pcl/indoor/point_cells.h>
#include <pcl/indoor/quantile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

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

/** The distances of a point to its closest others in its cell and those around,
 * ascending; infinite where there are fewer. */
using Closest = std::array<float, pcl::indoor::closest_neighbors>;

Closest
closestOthers(const std::vector<Eigen::Vector3f>& points,
              const pcl::indoor::PointCells& cells,
              const pcl::indoor::Adjacency& around,
              std::uint32_t cell)
{
  const auto query = firstPoint(points, cells, cell);
  Closest closest;
  closest.fill(std::numeric_limits<float>::infinity());
  const auto visit = [&](std::uint32_t other_cell) {
    for (const auto point : cells.pointsOf(other_cell)) {
      float squared = (points[point] - points[query]).squaredNorm();
      if (point == query || !(squared < closest.back()))
        continue;
      for (auto& other : closest)
        if (squared < other)
          std::swap(squared, other);
    }
  };
  visit(cell);
  for (const auto other : around.of(cell))
    visit(other);
  for (auto& distance : closest)
    distance = std::sqrt(distance);
  return closest;
}

/** To the nearest point that is no copy: those before the largest step, if there is
 * one, are copies. */
float
beyondCopies(const Closest& closest)
{
  constexpr float least_step = 2; // times as far, as a second ring of points is
  auto result = closest.front();
  float largest = least_step;
  for (std::size_t k = 1; k < closest.size(); ++k)
    if (std::isfinite(closest[k]) && closest[k] > largest * closest[k - 1]) {
      result = closest[k];
      largest = closest[k] / closest[k - 1];
    }
  return result;
}

struct Spacing {
  double nearest = std::numeric_limits<double>::infinity();  ///< medians, metres
  double farthest = std::numeric_limits<double>::infinity(); ///< of the closest
  double beyond_copies = std::numeric_limits<double>::infinity();

  /** Are points closer to one another than points of one scan ever are? In scans with
   * lasers and cameras, simulated or real, random or in rows, the nearest of eight is
   * at more than a third of the distance of the eighth. */
  bool
  hasCopies() const
  {
    return mayHaveCopies(farthest);
  }

  bool
  mayHaveCopies(double eighth) const
  {
    return nearest < 0.2 * eighth;
  }
};

Spacing
spacingOf(const std::vector<Eigen::Vector3f>& points,
          const pcl::indoor::PointCells& cells)
{
  const auto around = pcl::indoor::cellAdjacency(cells.keys);
  const auto stride = std::max<std::size_t>(1, cells.size() / sample_count);
  std::vector<double> nearest, farthest, beyond_copies;
  for (std::size_t c = 0; c < cells.size(); c += stride) {
    const auto closest =
        closestOthers(points, cells, around, static_cast<std::uint32_t>(c));
    nearest.push_back(closest.front());
    farthest.push_back(closest.back());
    beyond_copies.push_back(beyondCopies(closest));
  }
  if (nearest.empty())
    return {};
  using pcl::indoor::median;
  return {median(nearest), median(farthest), median(beyond_copies)};
}

} // namespace

namespace pcl::indoor {

double
raisedToResolution(const std::vector<Eigen::Vector3f>& points, double voxel_size)
{
  constexpr int most_doublings = 12;
  double cell_size = voxel_size, resolution = 0;
  for (int i = 0; i < most_doublings && points.size() > 1; ++i, cell_size *= 2) {
    const auto spacing = spacingOf(points, groupByCell(points, cell_size));
    if (resolution == 0 && std::isfinite(spacing.nearest))
      resolution = spacing.nearest;
    if (std::isfinite(spacing.nearest) && !spacing.mayHaveCopies(4 * cell_size))
      break; // whatever the next cells show, twice as large
    if (!std::isfinite(spacing.farthest))
      continue;
    if (spacing.hasCopies())
      resolution = spacing.beyond_copies;
    break;
  }
  return std::max(voxel_size, radius_factor * resolution);
}

} // namespace pcl::indoor
