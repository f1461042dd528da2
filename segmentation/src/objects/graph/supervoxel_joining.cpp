/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/graph/supervoxel_joining.h"

#include <algorithm>

namespace pcl::indoor {
namespace {

constexpr double bend_threshold = 15; // degrees, mean bend of a border of two pieces

} // namespace

SurfaceDistance
distanceOf(const ObjectSegmentationOptions& options)
{
  SurfaceDistance distance;
  distance.seed_size = options.seed_size;
  distance.spatial_weight = options.spatial_weight;
  distance.normal_weight = options.normal_weight;
  return distance;
}

std::vector<std::uint32_t>
joinByBends(const Supervoxels& supervoxels,
            const std::vector<SurfaceEdge>& edges,
            std::uint32_t min_segment_size)
{
  return clusterByBorders(supervoxels.size(),
                          bendBorders(supervoxels, edges),
                          bend_threshold,
                          min_segment_size);
}

std::map<std::uint32_t, std::uint32_t>
joinNamed(const NamedSupervoxels& given, const JoinSupervoxels& join)
{
  const auto& [names, centroids, normals, adjacency] = given;
  Supervoxels supervoxels;
  supervoxels.centroids = centroids;
  supervoxels.normals = normals;
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
    edges.push_back({source, target, 1});
  }
  const auto segments = join(supervoxels, edges);
  std::map<std::uint32_t, std::uint32_t> segment_of_name;
  for (std::size_t i = 0; i < names.size(); ++i)
    segment_of_name[names[i]] = segments[i] + 1;
  return segment_of_name;
}

std::map<std::uint32_t, std::uint32_t>
segmentSupervoxels(const NamedSupervoxels& given,
                   const ObjectSegmentationOptions& options)
{
  return joinNamed(given, [&options](const auto& supervoxels, const auto& edges) {
    return joinByBends(supervoxels, edges, options.min_segment_size);
  });
}

} // namespace pcl::indoor
