/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/dbscan.h>

#include "clustering/single_linkage.h"

#include <pcl/indoor/disjoint_sets.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

void
dbscan_detail::requireValid(const DBSCANOptions& options)
{
  if (!(options.epsilon >= 0.0) || !std::isfinite(options.epsilon))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Epsilon must be finite and not negative, but is "
                            << options.epsilon << ".");
  if (options.min_samples < 1)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "A core point has at least 1 point within epsilon, not 0.");
  if (options.min_cluster_size < 1)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The smallest cluster must have at least 1 point, not 0.");
}

std::vector<int>
dbscanFromSpanningForest(std::size_t count,
                         const std::vector<HDBSCANEdge>& forest,
                         const std::vector<double>& core_distances,
                         const DBSCANOptions& options)
{
  dbscan_detail::requireValid(options);
  if (core_distances.size() != count)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        core_distances.size()
                            << " core distances for " << count << " points.");
  requireWithin(count, forest);
  DisjointSets components(count);
  for (const auto& edge : forest)
    if (edge.distance <= options.epsilon) // so both ends are core points
      components.merge(components.find(edge.source), components.find(edge.target));
  std::vector<int> label_of_root(count, -1);
  std::vector<int> labels(count, -1);
  int clusters = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t root = components.find(static_cast<std::uint32_t>(i));
    if (!(core_distances[i] <= options.epsilon) ||
        components.size(root) < options.min_cluster_size)
      continue;
    if (label_of_root[root] < 0)
      label_of_root[root] = clusters++;
    labels[i] = label_of_root[root];
  }
  return labels;
}

std::vector<int>
dbscan(std::size_t count,
       const std::vector<HDBSCANEdge>& edges,
       const DBSCANOptions& options)
{
  dbscan_detail::requireValid(options);
  const auto core =
      hdbscan_detail::graphCoreDistances(count, edges, options.min_samples);
  std::vector<HDBSCANEdge> near;
  for (HDBSCANEdge edge : edges) {
    edge.distance = std::max({edge.distance, core[edge.source], core[edge.target]});
    if (edge.distance <= options.epsilon)
      near.push_back(edge);
  }
  return dbscanFromSpanningForest(
      count, minimumSpanningForest(count, std::move(near)), core, options);
}

} // namespace pcl::indoor
