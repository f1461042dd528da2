/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/non_convex_voxels.h"

#include <pcl/filters/non_convex_points.h>

#include <cmath>

namespace pcl::indoor {
namespace {

/** Neighbours nearer to the tangent plane count for neither half-space; voxels. */
constexpr double plane_tolerance = 0.3;

} // namespace

std::vector<std::uint8_t>
findNonConvexVoxels(const ObjectScene& scene, const ObjectSegmentationOptions& options)
{
  const auto& voxels = scene.voxels;
  const double on_plane = plane_tolerance * scene.voxel_size;
  std::vector<std::uint8_t> removed(voxels.size(), 0);
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    if (scene.plane_of_voxel[v] != 0 ||
        !(voxels.curvatures[v] > options.curvature_threshold))
      continue;
    double positive = 0, negative = 0;
    for (const auto other : voxels.neighbors.of(v)) {
      const float height =
          voxels.normals[v].dot(voxels.centroids[other] - voxels.centroids[v]);
      const auto points = voxels.cells.pointsOf(other).size();
      if (std::abs(height) > on_plane)
        (height > 0 ? positive : negative) += points;
    }
    removed[v] = isNonConvex(positive, negative, options.ratio_threshold);
  }
  return removed;
}

} // namespace pcl::indoor
