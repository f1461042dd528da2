/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/segmentation/hdbscan.h>

#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief Check the edges of a graph of points.
 * \throws pcl::BadArgumentException if one leaves the points, or has a distance that is
 * negative or NaN
 */
void
requireWithin(std::size_t count, const std::vector<HDBSCANEdge>& edges);

/** \brief The single-linkage hierarchy of points, as a tree.
 *
 * Nodes 0 ... count - 1 are the points, the others are merges, children before parents.
 * A merge joins all the parts that become connected at exactly its distance: it has two
 * children or more, and none of them has its distance. That makes the tree the same for
 * every order of the points and every choice among equally short spanning trees.
 */
struct SingleLinkageTree {
  std::size_t count = 0;         ///< number of points
  std::vector<double> distance;  ///< of each node; 0 for points
  std::vector<std::size_t> size; ///< points below each node
  std::vector<int> first_child;  ///< of each node; -1 for points
  std::vector<int> next_sibling; ///< of each node; -1 for the last child
  int root = -1;                 ///< -1 without points

  /** \brief Call visit(child) for each child of a node. */
  template <typename Visit>
  void
  forEachChild(int node, const Visit& visit) const
  {
    for (int child = first_child[static_cast<std::size_t>(node)]; child >= 0;
         child = next_sibling[static_cast<std::size_t>(child)])
      visit(child);
  }

  /** \brief Call visit(point) for each point below a node, or for the node itself. */
  template <typename Visit>
  void
  forEachPoint(int node, const Visit& visit) const
  {
    std::vector<int> stack{node};
    while (!stack.empty()) {
      const int top = stack.back();
      stack.pop_back();
      if (static_cast<std::size_t>(top) < count)
        visit(static_cast<std::size_t>(top));
      else
        forEachChild(top, [&](int child) { stack.push_back(child); });
    }
  }
};

/** \brief Build the hierarchy from a minimum spanning forest.
 * \param[in] forest edges in any order; trees are joined at an infinite distance, as
 * are the ends of infinitely long edges
 * \throws pcl::BadArgumentException if the edges are no forest of the points or a
 * distance is negative or NaN
 */
SingleLinkageTree
singleLinkageTree(std::size_t count, std::vector<HDBSCANEdge> forest);

} // namespace pcl::indoor
