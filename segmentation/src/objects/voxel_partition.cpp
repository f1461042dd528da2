/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/voxel_partition.h"

#include "objects/graph/point_recovery.h"
#include "objects/non_convex_voxels.h"

namespace {

using pcl::indoor::DetailedSegmentation;
using pcl::indoor::Supervoxels;

/** Segments of voxels, the planes after those of the supervoxels; too small ones,
 * islands among removed voxels, are left open. */
std::vector<std::uint32_t>
segmentsOfVoxels(const std::vector<std::uint32_t>& segment_of_supervoxel,
                 std::uint32_t min_segment_size,
                 const DetailedSegmentation& result)
{
  std::vector<std::uint32_t> size(segment_of_supervoxel.size(), 0);
  for (const auto segment : segment_of_supervoxel)
    ++size[segment];
  std::vector<std::uint32_t> segments(result.scene.voxels.size(), Supervoxels::none);
  for (std::size_t v = 0; v < result.scene.voxels.size(); ++v) {
    const auto supervoxel = result.supervoxels.label_of_voxel[v];
    if (result.scene.plane_of_voxel[v] != 0)
      segments[v] =
          static_cast<std::uint32_t>(size.size()) + result.scene.plane_of_voxel[v] - 1;
    if (supervoxel == Supervoxels::none)
      continue;
    const auto segment = segment_of_supervoxel[supervoxel];
    if (size[segment] >= min_segment_size)
      segments[v] = segment;
  }
  return segments;
}

} // namespace

namespace pcl::indoor {

std::vector<std::uint32_t>
partitionVoxels(const ObjectSegmentationOptions& options,
                const JoinSupervoxels& join,
                DetailedSegmentation& result)
{
  const auto distance = distanceOf(options);
  const auto& scene = result.scene;
  result.removed = findNonConvexVoxels(scene, options);
  auto left_out = scene.structureFlags();
  for (std::size_t v = 0; v < left_out.size(); ++v)
    left_out[v] |= result.removed[v];
  result.supervoxels = growSupervoxels(scene.voxels,
                                       left_out,
                                       options.seed_size / options.voxel_size,
                                       distance,
                                       options.threads);
  result.edges = surfaceEdges(scene.voxels, result.supervoxels);
  auto segments = segmentsOfVoxels(
      join(result.supervoxels, result.edges), options.min_segment_size, result);
  recoverLabels(scene.voxels.centroids,
                scene.voxels.normals,
                scene.voxels.neighbors,
                distance,
                segments);
  labelRemainder(
      scene.voxels.neighbors,
      static_cast<std::uint32_t>(result.supervoxels.size() + scene.planes.size()),
      segments);
  return segments;
}

void
spreadToPoints(const std::vector<std::uint32_t>& segment_of_voxel,
               DetailedSegmentation& result)
{
  for (const auto voxel : result.scene.voxels.cells.cell_of_point)
    result.segment_of_point.push_back(segment_of_voxel[voxel]);
}

} // namespace pcl::indoor
