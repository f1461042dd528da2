/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "clustering/single_linkage.h"

#include <pcl/indoor/disjoint_sets.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <limits>

namespace pcl::indoor {
namespace {

/** Joins components bottom up; knows the topmost node of each. */
class TreeBuilder {
public:
  explicit TreeBuilder(std::size_t count)
  : components_(count)
  , top_(count)
  {
    tree_.count = count;
    tree_.distance.assign(count, 0.0);
    tree_.size.assign(count, 1);
    tree_.first_child.assign(count, -1);
    tree_.next_sibling.assign(count, -1);
    last_child_.assign(count, -1);
    for (std::size_t i = 0; i < count; ++i)
      top_[i] = static_cast<int>(i);
  }

  /** Join the components of two points; distances must not fall from call to call. */
  void
  join(std::uint32_t source, std::uint32_t target, double distance)
  {
    const std::uint32_t a = components_.find(source), b = components_.find(target);
    if (a == b)
      PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                          "The edges of the spanning forest form a cycle.");
    const int first = top_[a], second = top_[b];
    int merged;
    if (isMergeAt(first, distance))
      merged =
          isMergeAt(second, distance) ? unite(first, second) : append(first, second);
    else if (isMergeAt(second, distance))
      merged = append(second, first);
    else
      merged = append(append(addMerge(distance), first), second);
    top_[components_.merge(a, b)] = merged;
  }

  SingleLinkageTree
  finish()
  {
    const auto count = static_cast<std::uint32_t>(tree_.count);
    for (std::uint32_t i = 1; i < count; ++i)
      if (components_.find(i) != components_.find(0))
        join(0, i, std::numeric_limits<double>::infinity());
    if (count > 0)
      tree_.root = top_[components_.find(0)];
    return std::move(tree_);
  }

private:
  bool
  isMergeAt(int node, double distance) const
  {
    return static_cast<std::size_t>(node) >= tree_.count &&
           tree_.distance[static_cast<std::size_t>(node)] == distance;
  }

  int
  addMerge(double distance)
  {
    tree_.distance.push_back(distance);
    tree_.size.push_back(0);
    tree_.first_child.push_back(-1);
    tree_.next_sibling.push_back(-1);
    last_child_.push_back(-1);
    return static_cast<int>(tree_.distance.size()) - 1;
  }

  int
  append(int merge, int child)
  {
    const auto m = static_cast<std::size_t>(merge);
    if (last_child_[m] < 0)
      tree_.first_child[m] = child;
    else
      tree_.next_sibling[static_cast<std::size_t>(last_child_[m])] = child;
    last_child_[m] = child;
    tree_.size[m] += tree_.size[static_cast<std::size_t>(child)];
    return merge;
  }

  /** Give all children of the later of two merges to the earlier one. */
  int
  unite(int first, int second)
  {
    const auto f = static_cast<std::size_t>(std::min(first, second));
    const auto s = static_cast<std::size_t>(std::max(first, second));
    tree_.next_sibling[static_cast<std::size_t>(last_child_[f])] = tree_.first_child[s];
    last_child_[f] = last_child_[s];
    tree_.size[f] += tree_.size[s];
    tree_.size[s] = 0; // nobody's child any more
    tree_.first_child[s] = -1;
    return static_cast<int>(f);
  }

  SingleLinkageTree tree_;
  std::vector<int> last_child_;
  DisjointSets components_;
  std::vector<int> top_; // of the component of each representative
};

} // namespace

void
requireWithin(std::size_t count, const std::vector<HDBSCANEdge>& edges)
{
  for (const auto& edge : edges)
    if (edge.source >= count || edge.target >= count || !(edge.distance >= 0.0))
      PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                          "Bad edge " << edge.source << " - " << edge.target
                                      << " at distance " << edge.distance << " among "
                                      << count << " points.");
}

SingleLinkageTree
singleLinkageTree(std::size_t count, std::vector<HDBSCANEdge> forest)
{
  requireWithin(count, forest);
  const auto shorter = [](const HDBSCANEdge& a, const HDBSCANEdge& b) {
    return a.distance < b.distance;
  };
  if (!std::is_sorted(forest.begin(), forest.end(), shorter))
    std::sort(forest.begin(), forest.end(), shorter);
  TreeBuilder builder(count);
  for (const auto& edge : forest)
    builder.join(edge.source, edge.target, edge.distance);
  return builder.finish();
}

} // namespace pcl::indoor
