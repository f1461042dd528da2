/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "thesis/objects/point_surface.h"

#include "objects/vector_moments.h"

#include <pcl/indoor/threads.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

using pcl::indoor::Adjacency;
using pcl::indoor::PointCells;

/** Call visit(index) for all points within a radius of the i-th, which is one of them.
 * The cells are as wide as the radius. */
template <typename Visit>
void
visitWithin(const std::vector<Eigen::Vector3f>& points,
            const PointCells& cells,
            const Adjacency& around,
            float squared_radius,
            std::size_t i,
            const Visit& visit)
{
  const auto visit_cell = [&](std::uint32_t cell) {
    for (const auto point : cells.pointsOf(cell))
      if ((points[point] - points[i]).squaredNorm() <= squared_radius)
        visit(point);
  };
  const auto own = cells.cell_of_point[i];
  visit_cell(own);
  for (const auto other : around.of(own))
    visit_cell(other);
}

} // namespace

namespace pcl::indoor {

SurfaceVoxels
pointsAsVoxels(const std::vector<Eigen::Vector3f>& points)
{
  SurfaceVoxels surface;
  surface.centroids = points;
  auto& cells = surface.cells;
  cells.keys.resize(points.size());
  cells.cell_of_point.resize(points.size());
  cells.points.resize(points.size());
  cells.offsets.resize(points.size() + 1);
  std::iota(cells.keys.begin(), cells.keys.end(), std::uint64_t{0});
  std::iota(cells.cell_of_point.begin(), cells.cell_of_point.end(), 0u);
  std::iota(cells.points.begin(), cells.points.end(), 0u);
  std::iota(cells.offsets.begin(), cells.offsets.end(), 0u);
  return surface;
}

void
estimatePointNormals(double radius, unsigned threads, SurfaceVoxels& surface)
{
  const auto& points = surface.centroids;
  const auto cells = groupByCell(points, radius);
  const auto around = cellAdjacency(cells.keys);
  const auto squared_radius = static_cast<float>(radius * radius);
  const auto count = static_cast<std::ptrdiff_t>(points.size());
  surface.normals.assign(points.size(), Eigen::Vector3f::Zero());
  surface.curvatures.assign(points.size(), 0.0f);
#pragma omp parallel for schedule(dynamic, 1024) num_threads(threadCount(threads))
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t>(i);
    VectorMoments offsets;
    visitWithin(points, cells, around, squared_radius, place, [&](std::uint32_t j) {
      offsets.add((points[j] - points[place]).cast<double>());
    });
    if (offsets.count < 3)
      continue;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(offsets.covariance());
    const Eigen::Vector3d spread = solver.eigenvalues().cwiseMax(0.0);
    if (!(spread.sum() > 0))
      continue;
    surface.normals[place] = solver.eigenvectors().col(0).cast<float>();
    surface.curvatures[place] = static_cast<float>(spread[0] / spread.sum());
  }
}

Eigen::Vector3f
labOfRgb(const Eigen::Vector3f& rgb)
{
  const Eigen::Vector3d linear = (rgb.cast<double>() / 255).unaryExpr([](double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  });
  Eigen::Matrix3d to_xyz;
  to_xyz << 0.4124, 0.3576, 0.1805, //
      0.2126, 0.7152, 0.0722,       //
      0.0193, 0.1192, 0.9505;
  const Eigen::Vector3d white = to_xyz * Eigen::Vector3d::Ones();
  const Eigen::Vector3d f =
      (to_xyz * linear).cwiseQuotient(white).unaryExpr([](double t) {
        constexpr double d = 6.0 / 29;
        return t > d * d * d ? std::cbrt(t) : t / (3 * d * d) + 4.0 / 29;
      });
  return Eigen::Vector3d(116 * f.y() - 16, 500 * (f.x() - f.y()), 200 * (f.y() - f.z()))
      .cast<float>();
}

Adjacency
neighborsWithin(const std::vector<Eigen::Vector3f>& points,
                double radius,
                const std::vector<std::uint8_t>& wanted)
{
  const auto cells = groupByCell(points, radius);
  const auto around = cellAdjacency(cells.keys);
  const auto squared_radius = static_cast<float>(radius * radius);
  Adjacency neighbors;
  neighbors.offsets.assign(1, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto begin = static_cast<std::ptrdiff_t>(neighbors.targets.size());
    if (wanted[i])
      visitWithin(points, cells, around, squared_radius, i, [&](std::uint32_t j) {
        if (j != i)
          neighbors.targets.push_back(j);
      });
    std::sort(neighbors.targets.begin() + begin, neighbors.targets.end());
    neighbors.offsets.push_back(static_cast<std::uint32_t>(neighbors.targets.size()));
  }
  return neighbors;
}

} // namespace pcl::indoor
