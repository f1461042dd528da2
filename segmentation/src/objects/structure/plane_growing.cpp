/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/structure/plane_growing.h"

#include "objects/vector_moments.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace {

using pcl::indoor::normal_cosine;
using pcl::indoor::sheet_cosine;
using pcl::indoor::StructurePlane;
using pcl::indoor::SurfaceVoxels;
using pcl::indoor::VectorMoments;

constexpr std::size_t min_region = 50;

/** Lay a plane through positions. */
void
fitThrough(const VectorMoments& positions, StructurePlane& plane)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(positions.covariance());
  plane.normal = solver.eigenvectors().col(0).normalized();
  plane.offset = plane.normal.dot(positions.mean());
}

/** Grow one region from a voxel; the plane is fitted anew whenever it has doubled. */
StructurePlane
growRegion(const SurfaceVoxels& voxels,
           std::uint32_t seed,
           double tolerance,
           std::vector<std::uint8_t>& taken)
{
  const auto place = [&](std::uint32_t v) {
    return Eigen::Vector3d(voxels.centroids[v].cast<double>());
  };
  StructurePlane plane;
  plane.normal = voxels.normals[seed].cast<double>();
  plane.offset = plane.normal.dot(place(seed));
  plane.voxels.assign(1, seed);
  taken[seed] = 1;
  VectorMoments positions;
  std::size_t next_fit = min_region / 2;
  for (std::size_t i = 0; i < plane.voxels.size(); ++i) {
    const auto v = plane.voxels[i];
    positions.add(place(v));
    if (i + 1 >= next_fit) {
      fitThrough(positions, plane);
      next_fit *= 2;
    }
    for (const auto other : voxels.neighbors.of(v)) {
      const double cosine = voxels.normals[other].cast<double>().dot(plane.normal);
      if (taken[other] || std::abs(cosine) < normal_cosine ||
          std::abs(plane.heightOf(place(other))) > tolerance)
        continue;
      taken[other] = 1;
      plane.voxels.push_back(other);
    }
  }
  if (plane.voxels.size() >= min_region)
    fitThrough(positions, plane);
  return plane;
}

/** Let the plane have the side of most of its voxels' normals. */
void
chooseSide(const SurfaceVoxels& voxels, StructurePlane& plane)
{
  double sum = 0;
  for (const auto v : plane.voxels)
    sum += voxels.normals[v].cast<double>().dot(plane.normal);
  if (sum < 0) {
    plane.normal *= -1;
    plane.offset *= -1;
  }
}

/** Regions of one plane, for example a floor on both sides of a cabinet. */
std::vector<StructurePlane>
uniteCoplanar(const SurfaceVoxels& voxels,
              const std::vector<StructurePlane>& regions,
              double tolerance)
{
  std::vector<StructurePlane> sheets;
  for (const auto& region : regions) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const auto v : region.voxels)
      middle += voxels.centroids[v].cast<double>();
    middle /= static_cast<double>(region.voxels.size());
    const auto same = std::find_if(sheets.begin(), sheets.end(), [&](const auto& s) {
      return s.normal.dot(region.normal) > sheet_cosine &&
             std::abs(s.heightOf(middle)) < tolerance;
    });
    if (same == sheets.end())
      sheets.push_back(region);
    else
      same->voxels.insert(
          same->voxels.end(), region.voxels.begin(), region.voxels.end());
  }
  return sheets;
}

} // namespace

namespace pcl::indoor {

std::vector<StructurePlane>
growPlanes(const SurfaceVoxels& voxels, double voxel_size, float flat_curvature)
{
  std::vector<std::uint32_t> seeds;
  for (std::uint32_t v = 0; v < voxels.size(); ++v)
    if (voxels.curvatures[v] <= flat_curvature && !voxels.normals[v].isZero())
      seeds.push_back(v);
  std::sort(seeds.begin(), seeds.end(), [&](auto a, auto b) {
    return std::tie(voxels.curvatures[a], a) < std::tie(voxels.curvatures[b], b);
  });
  std::vector<std::uint8_t> taken(voxels.size(), 0);
  std::vector<StructurePlane> regions;
  for (const auto seed : seeds) {
    if (taken[seed])
      continue;
    auto region = growRegion(voxels, seed, voxel_size, taken);
    if (region.voxels.size() < min_region)
      continue;
    chooseSide(voxels, region);
    regions.push_back(std::move(region));
  }
  std::stable_sort(regions.begin(), regions.end(), [](const auto& a, const auto& b) {
    return a.voxels.size() > b.voxels.size();
  });
  return uniteCoplanar(voxels, regions, same_surface_voxels * voxel_size);
}

} // namespace pcl::indoor
