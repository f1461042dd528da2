/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "thesis/objects/edge_partition.h"

#include "objects/graph/supervoxel_joining.h"

#include <pcl/indoor/disjoint_sets.h>

namespace {

using pcl::indoor::DisjointSets;
using pcl::indoor::SurfaceEdge;

/** Add each small segment to its largest neighbour, smallest segments first. */
void
absorbSmallSegments(DisjointSets& segments,
                    std::size_t node_count,
                    const std::vector<SurfaceEdge>& edges)
{
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<std::uint32_t> target(node_count, pcl::indoor::Supervoxels::none);
    const auto propose = [&](std::uint32_t small, std::uint32_t other) {
      if (segments.size(small) > pcl::indoor::largest_small_segment)
        return;
      auto& best = target[small];
      if (best == pcl::indoor::Supervoxels::none ||
          segments.size(other) > segments.size(best) ||
          (segments.size(other) == segments.size(best) && other < best))
        best = other;
    };
    for (const auto& edge : edges) {
      const auto a = segments.find(edge.source), b = segments.find(edge.target);
      if (a == b)
        continue;
      propose(a, b);
      propose(b, a);
    }
    for (std::uint32_t i = 0; i < node_count; ++i) {
      if (target[i] == pcl::indoor::Supervoxels::none || segments.find(i) != i)
        continue;
      const auto into = segments.find(target[i]);
      if (into == i || segments.size(i) > pcl::indoor::largest_small_segment)
        continue;
      segments.merge(i, into);
      changed = true;
    }
  }
}

} // namespace

namespace pcl::indoor {

std::vector<std::uint8_t>
convexEdges(const Supervoxels& supervoxels,
            const std::vector<SurfaceEdge>& edges,
            float concavity_tolerance_degrees)
{
  std::vector<std::uint8_t> is_convex;
  is_convex.reserve(edges.size());
  for (const auto& edge : edges) {
    const auto &normal_1 = supervoxels.normals[edge.source],
               &normal_2 = supervoxels.normals[edge.target];
    const Eigen::Vector3f towards_1 =
        supervoxels.centroids[edge.source] - supervoxels.centroids[edge.target];
    // Equal to comparing the angles between the connection and the two normals.
    is_convex.push_back(towards_1.dot(normal_1) >= towards_1.dot(normal_2) ||
                        angleDegrees(normal_1, normal_2) < concavity_tolerance_degrees);
  }
  return is_convex;
}

std::vector<WeightedEdge>
weighEdges(const Supervoxels& supervoxels,
           const std::vector<SurfaceEdge>& edges,
           const std::vector<std::uint8_t>& is_convex,
           const SurfaceDistance& distance,
           float concavity_weight)
{
  std::vector<WeightedEdge> weighted;
  weighted.reserve(edges.size());
  for (const auto& edge : edges) {
    const auto& looks = supervoxels.appearance;
    const float d = distance(supervoxels.centroids[edge.source],
                             supervoxels.normals[edge.source],
                             supervoxels.centroids[edge.target],
                             supervoxels.normals[edge.target]) +
                    distance.ofAppearance(looks, edge.source, looks, edge.target);
    const bool convex = is_convex[weighted.size()] != 0;
    weighted.push_back(
        {edge.source, edge.target, convex ? concavity_weight * d * d : d});
  }
  return weighted;
}

std::vector<std::uint32_t>
convexSegments(std::size_t node_count,
               const std::vector<SurfaceEdge>& edges,
               const std::vector<std::uint8_t>& is_convex)
{
  DisjointSets segments(node_count);
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (is_convex[i])
      segments.merge(segments.find(edges[i].source), segments.find(edges[i].target));
  absorbSmallSegments(segments, node_count, edges);
  return segments.labels();
}

namespace thesis {

SurfaceDistance
distanceOf(const ObjectOptions& options)
{
  auto distance = indoor::distanceOf(options.shared);
  if (options.on_points) {
    distance.color_weight = options.on_points->color_weight;
    distance.shape_weight = options.on_points->fpfh_weight;
  }
  return distance;
}

std::vector<std::uint32_t>
joinOverEdges(const Supervoxels& supervoxels,
              const std::vector<SurfaceEdge>& edges,
              const ObjectOptions& options)
{
  const auto& graph = options.edges;
  const auto is_convex =
      convexEdges(supervoxels, edges, graph.concavity_tolerance_degrees);
  if (graph.partition == EdgePartition::Lccp)
    return convexSegments(supervoxels.size(), edges, is_convex);
  return segmentGraph(
      supervoxels.size(),
      weighEdges(
          supervoxels, edges, is_convex, distanceOf(options), graph.concavity_weight),
      graph.graph_scale,
      options.shared.min_segment_size);
}

} // namespace thesis
} // namespace pcl::indoor
