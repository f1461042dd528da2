/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "thesis/objects/graph_segmentation.h"

#include <pcl/exceptions.h>
#include <pcl/indoor/disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace {

using pcl::indoor::WeightedEdge;

void
requireValid(std::size_t node_count,
             const std::vector<WeightedEdge>& edges,
             float scale)
{
  if (!(scale >= 0) || !std::isfinite(scale))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The scale must be finite and not negative, not " << scale
                                                                          << ".");
  for (const auto& edge : edges) {
    if (edge.source >= node_count || edge.target >= node_count)
      PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                          "The edge from " << edge.source << " to " << edge.target
                                           << " leaves a graph of " << node_count
                                           << " nodes.");
    if (!(edge.weight >= 0) || !std::isfinite(edge.weight))
      PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                          "An edge weight must be finite and not negative, not "
                              << edge.weight << ".");
  }
}

} // namespace

namespace pcl::indoor {

std::vector<std::uint32_t>
segmentGraph(std::size_t node_count,
             std::vector<WeightedEdge> edges,
             float scale,
             std::uint32_t min_segment_size)
{
  requireValid(node_count, edges, scale);
  for (auto& edge : edges)
    if (edge.target < edge.source)
      std::swap(edge.source, edge.target);
  std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) {
    return std::tie(a.weight, a.source, a.target) <
           std::tie(b.weight, b.source, b.target);
  });
  DisjointSets segments(node_count);
  std::vector<float> internal(node_count, 0.0f); // Int(C), at C's representative
  const auto bound = [&](std::uint32_t c) {      // Int(C) + tau(C), Eq. (2.17)
    return internal[c] + scale / static_cast<float>(segments.size(c));
  };
  for (const auto& edge : edges) {
    const auto a = segments.find(edge.source);
    const auto b = segments.find(edge.target);
    if (a != b && edge.weight <= std::min(bound(a), bound(b))) // Eq. (2.16)
      internal[segments.merge(a, b)] = edge.weight;
  }
  for (const auto& edge : edges) {
    const auto a = segments.find(edge.source);
    const auto b = segments.find(edge.target);
    if (std::min(segments.size(a), segments.size(b)) < min_segment_size)
      segments.merge(a, b);
  }
  return segments.labels();
}

} // namespace pcl::indoor
