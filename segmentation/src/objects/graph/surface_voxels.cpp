/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/graph/surface_voxels.h"

#include <pcl/features/unit_normals.h>
#include <pcl/indoor/threads.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cassert>

namespace {

using pcl::indoor::SurfaceVoxels;

/** Sums over points: their number, coordinates, and products of coordinates. */
using Moments = Eigen::Matrix<double, 10, 1>;

Moments
momentsOf(const Eigen::Vector3d& p)
{
  Moments m;
  m << 1, p.x(), p.y(), p.z(), p.x() * p.x(), p.x() * p.y(), p.x() * p.z(),
      p.y() * p.y(), p.y() * p.z(), p.z() * p.z();
  return m;
}

std::vector<Moments>
voxelMoments(const std::vector<Eigen::Vector3f>& points, const SurfaceVoxels& voxels)
{
  std::vector<Moments> moments(voxels.size(), Moments::Zero());
  for (std::size_t i = 0; i < points.size(); ++i)
    moments[voxels.cells.cell_of_point[i]] += momentsOf(points[i].cast<double>());
  return moments;
}

/** Add to each voxel's moments those of its neighbours. */
std::vector<Moments>
spread(const std::vector<Moments>& moments, const SurfaceVoxels& voxels, int threads)
{
  std::vector<Moments> sums(moments.size());
  const auto count = static_cast<std::ptrdiff_t>(moments.size());
#pragma omp parallel for num_threads(threads)
  for (std::ptrdiff_t v = 0; v < count; ++v) {
    Moments sum = moments[v];
    for (const auto other : voxels.neighbors.of(v))
      sum += moments[other];
    sums[v] = sum;
  }
  return sums;
}

/** Fit a plane, Eq. (2.4), (2.5) and (2.8). */
void
fitPlane(const Moments& m, Eigen::Vector3f& normal, float& curvature)
{
  normal.setZero();
  curvature = 0;
  if (m[0] < 3)
    return;
  const Eigen::Vector3d mean = m.segment<3>(1) / m[0];
  Eigen::Matrix3d covariance;
  covariance << m[4], m[5], m[6], m[5], m[7], m[8], m[6], m[8], m[9];
  covariance = covariance / m[0] - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(0);
  const double spread = values.sum();
  // A line or a single place has no plane: two eigenvalues vanish.
  if (!(values[1] > 1e-6 * spread) || !(spread > 0))
    return;
  normal = solver.eigenvectors().col(0).cast<float>().normalized();
  curvature = static_cast<float>(values[0] / spread);
}

} // namespace

namespace pcl::indoor {

SurfaceVoxels
surfaceVoxels(const std::vector<Eigen::Vector3f>& points,
              const std::vector<Eigen::Vector3f>& grid_points,
              double voxel_size)
{
  assert(grid_points.empty() || grid_points.size() == points.size());
  SurfaceVoxels voxels;
  voxels.cells = groupByCell(grid_points.empty() ? points : grid_points, voxel_size);
  voxels.neighbors = cellAdjacency(voxels.cells.keys);
  const auto count = voxels.cells.size();
  std::vector<Eigen::Vector3d> sums(count, Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < points.size(); ++i)
    sums[voxels.cells.cell_of_point[i]] += points[i].cast<double>();
  voxels.centroids.resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    const auto size = voxels.cells.pointsOf(v).size();
    voxels.centroids[v] = (sums[v] / static_cast<double>(size)).cast<float>();
  }
  return voxels;
}

void
estimateNormals(const std::vector<Eigen::Vector3f>& points,
                SurfaceVoxels& voxels,
                unsigned threads)
{
  const auto moments =
      spread(voxelMoments(points, voxels), voxels, threadCount(threads));
  voxels.normals.resize(voxels.size());
  voxels.curvatures.resize(voxels.size());
  const auto count = static_cast<std::ptrdiff_t>(voxels.size());
#pragma omp parallel for num_threads(threadCount(threads))
  for (std::ptrdiff_t v = 0; v < count; ++v)
    fitPlane(moments[v], voxels.normals[v], voxels.curvatures[v]);
}

void
averageNormals(const std::vector<Eigen::Vector3f>& point_normals, SurfaceVoxels& voxels)
{
  voxels.normals.assign(voxels.size(), Eigen::Vector3f::Zero());
  for (std::size_t i = 0; i < point_normals.size(); ++i)
    if (isUnitNormal(point_normals[i]))
      voxels.normals[voxels.cells.cell_of_point[i]] += point_normals[i];
  for (auto& normal : voxels.normals)
    normal = normal.norm() > 1e-6f ? normal.normalized() : Eigen::Vector3f::Zero();
}

} // namespace pcl::indoor
