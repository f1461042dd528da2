/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/unit_normals.h>

#include "internal/point_bounds.h"

#include <pcl/indoor/point_cells.h>
#include <pcl/indoor/quantile.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace {

using pcl::indoor::NumberRange;
using pcl::indoor::PointCells;
using Vectors = std::vector<Eigen::Vector3f>;

constexpr std::size_t fewest_in_patch = 12;   // points that a plane is fitted to
constexpr std::size_t most_in_patch = 48;     // points, the median
constexpr std::size_t most_in_sample = 20000; // points that are looked at in the end
constexpr std::size_t fewest_patches = 20;    // that say something

std::size_t
unitCount(const Vectors& normals)
{
  return static_cast<std::size_t>(
      std::count_if(normals.begin(), normals.end(), pcl::indoor::isUnitNormal));
}

double
medianCount(const PointCells& cells)
{
  std::vector<double> counts;
  for (const auto cell : cells.cell_of_point)
    counts.push_back(static_cast<double>(cells.pointsOf(cell).size()));
  return pcl::indoor::median(counts);
}

/** Points in cells that are small, of large clouds from some cells all over it. */
struct Patches {
  std::vector<std::uint32_t> points; ///< of the cloud, those in the cells
  PointCells cells;
};

Patches
patchesOf(const Vectors& points)
{
  // Cells of a room's surfaces with more points than wanted, but not many passes more.
  const double across = std::clamp(
      0.5 * std::sqrt(static_cast<double>(points.size() / most_in_patch)), 2.0, 32.0);
  double size =
      std::max(pcl::indoor::boundsOf(points).sizes().maxCoeff() / across, 1e-6);
  Patches patches;
  patches.points.resize(points.size());
  std::iota(patches.points.begin(), patches.points.end(), 0u);
  for (int halvings = 0; halvings < 15; ++halvings, size /= 2) {
    Vectors positions;
    for (const auto i : patches.points)
      positions.push_back(points[i]);
    patches.cells = pcl::indoor::groupByCell(positions, size);
    if (medianCount(patches.cells) <= most_in_patch)
      break;
    const auto& cells = patches.cells;
    const auto stride =
        std::min(patches.points.size() / most_in_sample, cells.size() / 64) + 1;
    std::vector<std::uint32_t> kept;
    for (std::size_t c = 0; c < cells.size(); c += stride)
      for (const auto i : cells.pointsOf(c))
        kept.push_back(patches.points[i]);
    patches.points = std::move(kept);
  }
  return patches;
}

/** The normal of the plane through points; zero if they are not flat. */
Eigen::Vector3f
flatNormal(const Vectors& points, const Patches& patches, const NumberRange& members)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto i : members)
    mean += points[patches.points[i]].cast<double>();
  mean /= static_cast<double>(members.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto i : members) {
    const Eigen::Vector3d offset = points[patches.points[i]].cast<double>() - mean;
    covariance += offset * offset.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const auto& values = solver.eigenvalues();
  constexpr double thinnest = 0.02, narrowest = 0.1; // shares of the largest
  const bool is_flat =
      values[0] < thinnest * values[2] && values[1] > narrowest * values[2];
  return is_flat ? Eigen::Vector3f(solver.eigenvectors().col(0).cast<float>())
                 : Eigen::Vector3f::Zero();
}

/** Do most of the normals stand on a surface? */
bool
agree(const Eigen::Vector3f& surface,
      const Vectors& normals,
      const Patches& patches,
      const NumberRange& members)
{
  constexpr float least_cosine = 0.866f; // 30 degrees
  const auto stands = [&](std::uint32_t i) {
    return std::abs(normals[patches.points[i]].dot(surface)) > least_cosine;
  };
  return 2 * std::count_if(members.begin(), members.end(), stands) >=
         static_cast<std::ptrdiff_t>(members.size());
}

} // namespace

namespace pcl::indoor {

bool
areUnitNormals(const std::vector<Eigen::Vector3f>& normals)
{
  return static_cast<double>(unitCount(normals)) >=
         least_unit_share * static_cast<double>(normals.size());
}

std::string
findNormalsProblem(const std::vector<Eigen::Vector3f>& points,
                   const std::vector<Eigen::Vector3f>& normals)
{
  if (normals.empty())
    return {};
  if (!areUnitNormals(normals))
    return std::to_string(unitCount(normals)) + " of " +
           std::to_string(normals.size()) + " have length 1";
  const auto patches = patchesOf(points);
  std::array<std::size_t, 3> all{}, agreeing{}; // patches by the axis they face
  for (std::size_t c = 0; c < patches.cells.size(); ++c) {
    const auto members = patches.cells.pointsOf(c);
    if (members.size() < fewest_in_patch)
      continue;
    const auto surface = flatNormal(points, patches, members);
    if (surface.isZero())
      continue;
    Eigen::Index axis = 0;
    surface.cwiseAbs().maxCoeff(&axis);
    ++all[static_cast<std::size_t>(axis)];
    agreeing[static_cast<std::size_t>(axis)] +=
        agree(surface, normals, patches, members);
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (all[axis] >= fewest_patches && 2 * agreeing[axis] < all[axis])
      return "on " + std::to_string(all[axis] - agreeing[axis]) + " of " +
             std::to_string(all[axis]) + " flat places that face " + "xyz"[axis] +
             " they stand askew";
  return {};
}

} // namespace pcl::indoor
