/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/hdbscan.h>

#include "clustering/single_linkage.h"

#include <pcl/exceptions.h>
#include <pcl/indoor/disjoint_sets.h>

#include <algorithm>
#include <utility>

namespace pcl::indoor {
namespace {

/** The neighbours of each point with the distances to them, in one array. */
struct Adjacency {
  std::vector<std::size_t> begin;
  std::vector<std::pair<std::uint32_t, double>> neighbours;
};

Adjacency
adjacency(std::size_t count, const std::vector<HDBSCANEdge>& edges)
{
  Adjacency a;
  a.begin.assign(count + 1, 0);
  for (const auto& edge : edges)
    if (edge.source != edge.target) {
      ++a.begin[edge.source + 1];
      ++a.begin[edge.target + 1];
    }
  for (std::size_t i = 0; i < count; ++i)
    a.begin[i + 1] += a.begin[i];
  a.neighbours.resize(a.begin[count]);
  std::vector<std::size_t> next(a.begin.begin(), a.begin.end() - 1);
  for (const auto& edge : edges)
    if (edge.source != edge.target) {
      a.neighbours[next[edge.source]++] = {edge.target, edge.distance};
      a.neighbours[next[edge.target]++] = {edge.source, edge.distance};
    }
  return a;
}

} // namespace

std::vector<double>
hdbscan_detail::graphCoreDistances(std::size_t count,
                                   const std::vector<HDBSCANEdge>& edges,
                                   std::size_t k)
{
  requireWithin(count, edges);
  std::vector<double> core(count, 0.0);
  if (k < 2)
    return core;
  Adjacency a = adjacency(count, edges);
  const auto at = [&](std::size_t place) {
    return a.neighbours.begin() + static_cast<std::ptrdiff_t>(place);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const auto first = at(a.begin[i]);
    std::sort(first, at(a.begin[i + 1])); // by neighbour, the shortest edge first
    const auto last =
        std::unique(first, at(a.begin[i + 1]), [](const auto& l, const auto& r) {
          return l.first == r.first;
        });
    if (last - first < static_cast<std::ptrdiff_t>(k - 1)) {
      core[i] = std::numeric_limits<double>::infinity();
      continue;
    }
    const auto kth = first + static_cast<std::ptrdiff_t>(k - 2);
    std::nth_element(first, kth, last, [](const auto& l, const auto& r) {
      return l.second < r.second;
    });
    core[i] = kth->second;
  }
  return core;
}

std::vector<HDBSCANEdge>
minimumSpanningForest(std::size_t count, std::vector<HDBSCANEdge> edges)
{
  requireWithin(count, edges);
  std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) {
    return a.distance < b.distance;
  });
  DisjointSets components(count);
  std::size_t kept = 0;
  for (const HDBSCANEdge edge : edges) {
    const std::uint32_t a = components.find(edge.source);
    const std::uint32_t b = components.find(edge.target);
    if (a == b)
      continue;
    components.merge(a, b);
    edges[kept++] = edge;
  }
  edges.resize(kept);
  edges.shrink_to_fit();
  return edges;
}

HDBSCANResult
hdbscan(std::size_t count,
        const std::vector<HDBSCANEdge>& edges,
        const std::vector<double>& core_distances,
        const HDBSCANOptions& options)
{
  hdbscan_detail::requireValid(options);
  requireWithin(count, edges);
  if (core_distances.size() != count)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        core_distances.size()
                            << " core distances for " << count << " points.");
  for (const double core : core_distances)
    if (!(core >= 0.0))
      PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                          "Bad core distance " << core << ".");
  std::vector<HDBSCANEdge> reach = edges;
  for (auto& edge : reach)
    edge.distance = std::max(
        {edge.distance, core_distances[edge.source], core_distances[edge.target]});
  return hdbscanFromSpanningForest(
      count, minimumSpanningForest(count, std::move(reach)), options);
}

HDBSCANResult
hdbscan(std::size_t count,
        const std::vector<HDBSCANEdge>& edges,
        const HDBSCANOptions& options)
{
  hdbscan_detail::requireValid(options);
  return hdbscan(count,
                 edges,
                 hdbscan_detail::graphCoreDistances(
                     count, edges, hdbscan_detail::minSamples(options)),
                 options);
}

} // namespace pcl::indoor
