/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/graph/supervoxel_joining.h"

#include <algorithm>

namespace pcl {
namespace indoor {
namespace {

constexpr double bend_threshold = 15; // degrees, mean bend of a border of two pieces

} // namespace

SurfaceDistance
distanceOf(const ObjectSegmentationOptions& options)
{
  const auto on_points = options.on_points.value_or(PointOptions());
  return {options.seed_size,
          options.spatial_weight,
          options.normal_weight,
          on_points.color_weight,
          on_points.fpfh_weight};
}

std::vector<std::uint32_t>
joinSupervoxels(const Supervoxels& supervoxels,
                const std::vector<SurfaceEdge>& edges,
                const ObjectSegmentationOptions& options)
{
  const auto count = supervoxels.size();
  if (options.partition == Partition::Lccp)
    return convexSegments(count, edges);
  if (options.partition == Partition::FelzenszwalbHuttenlocher)
    return segmentGraph(
        count,
        weighEdges(
            supervoxels, edges, distanceOf(options), options.edges.concavity_weight),
        options.edges.graph_scale,
        options.min_segment_size);
  return clusterByBorders(
      count, bendBorders(supervoxels, edges), bend_threshold, options.min_segment_size);
}

std::map<std::uint32_t, std::uint32_t>
segmentSupervoxels(const NamedSupervoxels& given,
                   const ObjectSegmentationOptions& given_options)
{
  const auto options = withSizes(given_options);
  const auto& [names, centroids, normals, adjacency] = given;
  Supervoxels supervoxels;
  supervoxels.centroids = centroids;
  supervoxels.normals = normals;
  supervoxels.voxel_counts.assign(names.size(), 1);
  const auto number = [&names = names](std::uint32_t name) {
    return static_cast<std::uint32_t>(
        std::lower_bound(names.begin(), names.end(), name) - names.begin());
  };
  std::vector<SurfaceEdge> edges; // in ascending order, as the multimap is
  for (const auto& [name, other_name] : adjacency) {
    const auto source = number(name), target = number(other_name);
    if (source >= target || target >= names.size() || names[source] != name ||
        names[target] != other_name)
      continue;
    edges.push_back({source,
                     target,
                     isConvexEdge(supervoxels.centroids[source],
                                  supervoxels.normals[source],
                                  supervoxels.centroids[target],
                                  supervoxels.normals[target],
                                  options.edges.concavity_tolerance_degrees),
                     1});
  }
  const auto segments = joinSupervoxels(supervoxels, edges, options);
  std::map<std::uint32_t, std::uint32_t> segment_of_name;
  for (std::size_t i = 0; i < names.size(); ++i)
    segment_of_name[names[i]] = segments[i] + 1;
  return segment_of_name;
}

} // namespace indoor
} // namespace pcl
