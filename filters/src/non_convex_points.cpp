/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/filters/non_convex_points.h>

#include "internal/option_check.h"

#include <pcl/exceptions.h>
#include <pcl/indoor/neighbor_distance.h>
#include <pcl/indoor/point_cells.h>
#include <pcl/indoor/require_valid.h>
#include <pcl/indoor/threads.h>

#include <cmath>

namespace {

using pcl::indoor::Adjacency;
using pcl::indoor::PointCells;

/** Call visit(point index) for all points of a cell and of the cells around it. */
template <typename Visit>
void
visitAround(const PointCells& cells,
            const Adjacency& around,
            std::uint32_t cell,
            const Visit& visit)
{
  const auto visit_cell = [&](std::uint32_t c) {
    for (const auto point : cells.pointsOf(c))
      visit(point);
  };
  visit_cell(cell);
  for (const auto other : around.of(cell))
    visit_cell(other);
}

} // namespace

namespace pcl::indoor {

std::string
findProblem(const NonConvexityOptions& options)
{
  OptionCheck check;
  check.require(options.radius >= 0 && std::isfinite(options.radius),
                "radius must not be negative",
                options.radius,
                " m");
  check.require(options.curvature_threshold >= 0 &&
                    options.curvature_threshold <= 1.0f / 3,
                "curvature threshold must be in [0, 1/3]",
                options.curvature_threshold);
  check.require(options.ratio_threshold >= 0 && options.ratio_threshold <= 1,
                "ratio threshold must be in [0, 1]",
                options.ratio_threshold);
  return check.problem();
}

std::vector<std::uint8_t>
nonConvexPoints(const std::vector<Eigen::Vector3f>& points,
                const std::vector<Eigen::Vector3f>& normals,
                const std::vector<float>& curvatures,
                const NonConvexityOptions& options)
{
  requireValid(options);
  if (normals.size() != points.size() || curvatures.size() != points.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        points.size()
                            << " points have " << normals.size() << " normals and "
                            << curvatures.size() << " curvatures.");
  double radius =
      options.radius > 0 ? options.radius : neighborhoodRadius(points, options.threads);
  if (!(radius > 0)) // no two different points: no neighbourhood
    radius = 1;
  const auto cells = groupByCell(points, radius);
  const auto around = cellAdjacency(cells.keys);
  const auto squared_radius = static_cast<float>(radius * radius);
  const auto count = static_cast<std::ptrdiff_t>(points.size());
  std::vector<std::uint8_t> non_convex(points.size(), 0);
#pragma omp parallel for schedule(dynamic, 1024)                                       \
    num_threads(threadCount(options.threads))
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    if (!(curvatures[i] > options.curvature_threshold) || !normals[i].allFinite())
      continue;
    std::size_t positive = 0, negative = 0;
    visitAround(cells, around, cells.cell_of_point[i], [&](std::uint32_t j) {
      const Eigen::Vector3f offset = points[j] - points[i];
      if (offset.squaredNorm() > squared_radius)
        return;
      const float height = normals[i].dot(offset);
      positive += height > 0;
      negative += height < 0;
    });
    non_convex[i] = isNonConvex(static_cast<double>(positive),
                                static_cast<double>(negative),
                                options.ratio_threshold);
  }
  return non_convex;
}

} // namespace pcl::indoor
