/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/hdbscan.h>

#include "clustering/single_linkage.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace hdbscan_detail {

void
requireValid(const HDBSCANOptions& options)
{
  if (options.min_cluster_size < 2)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The smallest cluster must have at least 2 points, not "
                            << options.min_cluster_size << ".");
  if (!(options.epsilon >= 0.0))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Epsilon must not be negative, but is " << options.epsilon
                                                                << ".");
}

void
throwBadDistance()
{
  PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                      "A distance between points is negative or not a number.");
}

} // namespace hdbscan_detail

namespace {

/** The density 1 / distance. A distance of 0 is replaced by half of the smallest
 * positive one, so that duplicate points have a large but finite density in any unit.
 */
class Density {
public:
  explicit Density(const SingleLinkageTree& tree)
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t node = tree.count; node < tree.distance.size(); ++node)
      if (tree.distance[node] > 0.0)
        smallest = std::min(smallest, tree.distance[node]);
    instead_of_zero_ = std::isfinite(smallest) ? smallest / 2.0 : 1.0;
  }

  double
  operator()(double distance) const
  {
    return 1.0 / (distance > 0.0 ? distance : instead_of_zero_);
  }

private:
  double instead_of_zero_;
};

/** Walks the hierarchy from the top; a part that is too small leaves its cluster, two
 * or more large parts end it.
 */
void
condense(const SingleLinkageTree& tree,
         const Density& density,
         std::size_t min_cluster_size,
         HDBSCANResult& result)
{
  result.point_cluster.assign(tree.count, 0);
  result.point_distance.assign(tree.count, 0.0);
  if (tree.count == 0)
    return;
  result.clusters.emplace_back();
  result.clusters[0].size = tree.count;
  std::vector<std::pair<int, int>> stack{{tree.root, 0}}; // node, cluster
  std::vector<int> large;
  while (!stack.empty()) {
    const int node = stack.back().first, cluster = stack.back().second;
    stack.pop_back();
    if (static_cast<std::size_t>(node) < tree.count)
      continue; // the only point there is
    const double distance = tree.distance[static_cast<std::size_t>(node)];
    large.clear();
    std::size_t leaving = 0;
    tree.forEachChild(node, [&](int child) {
      const std::size_t size = tree.size[static_cast<std::size_t>(child)];
      if (size >= min_cluster_size) {
        large.push_back(child);
        return;
      }
      leaving += size;
      tree.forEachPoint(child, [&](std::size_t point) {
        result.point_cluster[point] = cluster;
        result.point_distance[point] = distance;
      });
    });
    if (large.size() != 1)
      for (const int child : large) {
        leaving += tree.size[static_cast<std::size_t>(child)];
        stack.emplace_back(child, static_cast<int>(result.clusters.size()));
        result.clusters.push_back(
            {cluster, distance, tree.size[static_cast<std::size_t>(child)], 0.0, -1});
      }
    else
      stack.emplace_back(large.front(), cluster);
    CondensedCluster& c = result.clusters[static_cast<std::size_t>(cluster)];
    c.stability +=
        static_cast<double>(leaving) * (density(distance) - density(c.birth_distance));
  }
}

/** Sums in ascending order, so that the sum does not depend on the order of the points.
 */
double
orderedSum(std::vector<double>& values)
{
  std::sort(values.begin(), values.end());
  double sum = 0.0;
  for (const double value : values)
    sum += value;
  return sum;
}

using Flags = std::vector<char>;

constexpr double rounding = 1e-12; // relative; of sums of stabilities

/** The set of clusters, none within another, of the largest total stability; of equally
 * stable ones the larger clusters.
 */
Flags
selectStablest(const std::vector<CondensedCluster>& clusters, bool root_allowed)
{
  Flags selected(clusters.size(), 0);
  std::vector<std::vector<double>> below(clusters.size()); // of the children
  for (std::size_t c = clusters.size(); c-- > 0;) {
    const bool leaf = below[c].empty();
    const double children = orderedSum(below[c]);
    const bool allowed = c > 0 || root_allowed;
    selected[c] =
        allowed && (leaf || clusters[c].stability >= children * (1.0 - rounding));
    if (clusters[c].parent >= 0)
      below[static_cast<std::size_t>(clusters[c].parent)].push_back(
          selected[c] ? clusters[c].stability : children);
  }
  return selected;
}

Flags
selectLeaves(const std::vector<CondensedCluster>& clusters, bool root_allowed)
{
  Flags selected(clusters.size(), 1);
  for (const auto& cluster : clusters)
    if (cluster.parent >= 0)
      selected[static_cast<std::size_t>(cluster.parent)] = 0;
  if (!selected.empty() && !root_allowed)
    selected[0] = 0;
  return selected;
}

/** Replaces clusters born below epsilon by their first ancestor that was not. */
void
climbToEpsilon(const std::vector<CondensedCluster>& clusters,
               double epsilon,
               bool root_allowed,
               Flags& selected)
{
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    std::size_t ancestor = c;
    while (selected[c] && clusters[ancestor].birth_distance < epsilon) {
      const auto parent = static_cast<std::size_t>(clusters[ancestor].parent);
      if (parent == 0 && !root_allowed)
        break;
      ancestor = parent;
    }
    if (ancestor != c) {
      selected[c] = 0;
      selected[ancestor] = 1; // comes before c, and needs no climb itself
    }
  }
}

/** Keeps only the topmost selected cluster on each way down. */
std::vector<int>
topmostSelected(const std::vector<CondensedCluster>& clusters, const Flags& selected)
{
  std::vector<int> chosen(clusters.size(), -1);
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    if (clusters[c].parent >= 0)
      chosen[c] = chosen[static_cast<std::size_t>(clusters[c].parent)];
    if (chosen[c] < 0 && selected[c])
      chosen[c] = static_cast<int>(c);
  }
  return chosen;
}

/** Numbers the chosen clusters by their first points. */
void
labelPoints(const std::vector<int>& chosen, double epsilon, HDBSCANResult& result)
{
  const std::size_t count = result.point_cluster.size();
  result.labels.assign(count, -1);
  for (std::size_t i = 0; i < count; ++i) {
    const int cluster = chosen[static_cast<std::size_t>(result.point_cluster[i])];
    if (cluster < 0)
      continue;
    // The whole hierarchy as one cluster: what epsilon or nothing at all joins is
    // noise.
    if (cluster == 0 && result.point_cluster[i] == 0 && count > 1 &&
        ((epsilon > 0.0 && result.point_distance[i] > epsilon) ||
         std::isinf(result.point_distance[i])))
      continue;
    CondensedCluster& c = result.clusters[static_cast<std::size_t>(cluster)];
    if (c.label < 0) {
      c.label = static_cast<int>(result.stabilities.size());
      result.stabilities.push_back(c.stability);
    }
    result.labels[i] = c.label;
  }
}

/** The largest density at which a point leaves each cluster or, with `nested`, one of
 * the clusters within it.
 */
std::vector<double>
largestDensities(const HDBSCANResult& result, const Density& density, bool nested)
{
  std::vector<double> largest(result.clusters.size(), 0.0);
  for (std::size_t i = 0; i < result.point_cluster.size(); ++i) {
    double& value = largest[static_cast<std::size_t>(result.point_cluster[i])];
    value = std::max(value, density(result.point_distance[i]));
  }
  // where a cluster ends in a split, its last points leave it there
  for (std::size_t c = result.clusters.size(); c-- > 1;) {
    const CondensedCluster& cluster = result.clusters[c];
    double& value = largest[static_cast<std::size_t>(cluster.parent)];
    value = std::max(value, nested ? largest[c] : density(cluster.birth_distance));
  }
  return largest;
}

void
ratePoints(const std::vector<int>& chosen,
           const Density& density,
           HDBSCANResult& result)
{
  const std::size_t count = result.labels.size();
  const auto until_split = largestDensities(result, density, false);
  const auto until_end = largestDensities(result, density, true);
  result.probabilities.assign(count, 0.0);
  result.outlier_scores.assign(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const auto last = static_cast<std::size_t>(result.point_cluster[i]);
    const double leaves = density(result.point_distance[i]);
    if (until_end[last] > 0.0)
      result.outlier_scores[i] = 1.0 - leaves / until_end[last];
    if (result.labels[i] < 0)
      continue;
    const double end = until_split[static_cast<std::size_t>(chosen[last])];
    result.probabilities[i] = end > 0.0 ? std::min(leaves, end) / end : 1.0;
  }
}

} // namespace

HDBSCANResult
hdbscanFromSpanningForest(std::size_t count,
                          std::vector<HDBSCANEdge> forest,
                          const HDBSCANOptions& options)
{
  hdbscan_detail::requireValid(options);
  const SingleLinkageTree tree = singleLinkageTree(count, std::move(forest));
  const Density density(tree);
  HDBSCANResult result;
  condense(tree, density, options.min_cluster_size, result);
  const bool root_allowed =
      options.allow_single_cluster && count >= options.min_cluster_size;
  Flags selected = options.selection == ClusterSelection::Leaf
                       ? selectLeaves(result.clusters, root_allowed)
                       : selectStablest(result.clusters, root_allowed);
  if (options.epsilon > 0.0)
    climbToEpsilon(result.clusters, options.epsilon, root_allowed, selected);
  const std::vector<int> chosen = topmostSelected(result.clusters, selected);
  labelPoints(chosen, options.epsilon, result);
  ratePoints(chosen, density, result);
  return result;
}

} // namespace pcl::indoor
