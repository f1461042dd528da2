/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/graph/object_voxels.h"

#include "objects/structure/structure_contacts.h"
#include <pcl/features/normal_orientation.h>
#include <pcl/filters/non_convex_points.h>

#include <algorithm>
#include <cmath>

namespace {

using pcl::indoor::ObjectSegmentationInput;
using pcl::indoor::ObjectSegmentationOptions;
using pcl::indoor::SurfaceVoxels;

constexpr unsigned normal_rings = 1; // reach of normals and curvature, voxels

/** The single-camera transform of LCCP: voxels that grow with the distance. */
std::vector<Eigen::Vector3f>
singleCameraGrid(const ObjectSegmentationInput& input)
{
  std::vector<Eigen::Vector3f> grid_points;
  grid_points.reserve(input.points.size());
  for (const auto& point : input.points) {
    const Eigen::Vector3f ray = point - input.viewpoint.front();
    const float depth = std::max(ray.z(), 1e-3f);
    grid_points.emplace_back(ray.x() / depth, ray.y() / depth, std::log(depth));
  }
  return grid_points;
}

void
findNormals(const ObjectSegmentationInput& input,
            const ObjectSegmentationOptions& options,
            unsigned thinning,
            SurfaceVoxels& voxels)
{
  pcl::indoor::estimateNormals(input.points, voxels, normal_rings, options.threads);
  if (!input.normals.empty()) {
    pcl::indoor::averageNormals(input.normals, voxels);
    return;
  }
  pcl::indoor::FreeSpaceOptions free_space;
  free_space.cell_size = 2 * options.voxel_size;
  free_space.threads = options.threads;
  free_space.sample_stride *= thinning;
  pcl::indoor::orientNormals(options.orientation,
                             voxels.centroids,
                             voxels.neighbors,
                             input.viewpoint,
                             free_space,
                             voxels.normals);
}

} // namespace

namespace pcl {
namespace indoor {

std::vector<StructurePlane>
makeObjectVoxels(const ObjectSegmentationInput& input,
                 const ObjectSegmentationOptions& options,
                 ObjectSegmentation& result)
{
  auto voxels = surfaceVoxels(input.points,
                              input.single_camera ? singleCameraGrid(input)
                                                  : std::vector<Eigen::Vector3f>(),
                              options.voxel_size);
  // Normals for the sides of large planes need fewer votes.
  const bool separate = options.separate_structure && !input.single_camera;
  findNormals(input, options, separate ? 4 : 1, voxels);
  result.plane_of_voxel.assign(voxels.size(), 0);
  RoomStructureOptions structure;
  structure.voxel_size = options.voxel_size;
  std::vector<StructurePlane> planes;
  if (separate)
    planes = findRoomStructure(voxels, structure);
  if (planes.empty()) {
    result.voxels = std::move(voxels);
    return planes;
  }
  const auto plane_of_point =
      pointsOfStructure(input.points, voxels, planes, structure);
  result.voxels = separateVoxels(
      input.points, plane_of_point, options.voxel_size, result.plane_of_voxel);
  findNormals(input, options, 1, result.voxels);
  const double seed_voxels = options.seed_size / options.voxel_size;
  const auto patch = static_cast<std::size_t>(seed_voxels * seed_voxels);
  returnIslands(result.voxels,
                planes,
                options.voxel_size,
                patch,
                options.min_segment_size * patch,
                result.plane_of_voxel);
  yieldContacts(input.points,
                voxels,
                planes,
                options.voxel_size,
                result.plane_of_voxel,
                result.voxels);
  return planes;
}

std::vector<std::uint8_t>
inStructure(const ObjectSegmentation& result)
{
  std::vector<std::uint8_t> flags;
  flags.reserve(result.plane_of_voxel.size());
  for (const auto plane : result.plane_of_voxel)
    flags.push_back(plane != 0);
  return flags;
}

std::vector<std::uint8_t>
findNonConvexVoxels(const SurfaceVoxels& voxels,
                    const std::vector<std::uint8_t>& in_plane,
                    const ObjectSegmentationOptions& options)
{
  const double on_plane = options.plane_tolerance * options.voxel_size;
  std::vector<std::uint8_t> removed(voxels.size(), 0);
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    if (in_plane[v] || !(voxels.curvatures[v] > options.curvature_threshold))
      continue;
    double positive = 0, negative = 0;
    for (auto j = voxels.neighbors.offsets[v]; j < voxels.neighbors.offsets[v + 1];
         ++j) {
      const auto other = voxels.neighbors.targets[j];
      const float height =
          voxels.normals[v].dot(voxels.centroids[other] - voxels.centroids[v]);
      const auto points = voxels.cells.offsets[other + 1] - voxels.cells.offsets[other];
      if (std::abs(height) > on_plane)
        (height > 0 ? positive : negative) += points;
    }
    removed[v] = isNonConvex(positive, negative, options.ratio_threshold);
  }
  return removed;
}

} // namespace indoor
} // namespace pcl
