/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/segmentation/voxel_grid.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief Maximum flow between two search trees (Boykov and Kolmogorov 2004) on a
 * 6-connected grid that is never stored as a graph.
 *
 * All edges of the grid have the same capacity to and fro, K. Thus the residuals of an
 * edge sum up to 2 K, each voxel knows both of them from its own, and a neighbour is
 * read only if there is something to do.
 */
class GridCutSolver {
public:
  GridCutSolver(const GridShape& shape,
                const std::vector<std::int16_t>& gain,
                int smoothness);

  /** \brief Find the maximum flow. \return its value */
  std::int64_t
  run();

  /** \brief Whether a voxel is reachable from the source after run(). */
  bool
  inside(std::size_t voxel) const
  {
    return nodes_[voxel].tree == SOURCE;
  }

private:
  using Index = std::uint32_t;
  static constexpr Index none = ~Index{0};
  enum Tree : std::uint8_t { FREE, SOURCE, SINK };
  // A node's parent is one of its six directions or one of these.
  static constexpr std::uint8_t terminal = 6;
  static constexpr std::uint8_t orphan = 7;

  struct Node {
    std::int32_t excess;   // residual of the edge from the source, or minus to the sink
    std::int32_t stamp;    // when distance was valid
    std::int32_t distance; // to the terminal, along the tree
    Index next;            // in the queue of active nodes; itself if last
    std::int16_t residual[6]; // towards the neighbours
    std::uint8_t links;       // bit d: there is a neighbour in direction d
    std::uint8_t parent;
    Tree tree;
  };

  static int
  opposite(int direction)
  {
    return direction ^ 1;
  }
  Index
  neighbour(Index i, int direction) const
  {
    return i + offset_[direction]; // wraps around for negative offsets
  }
  /** \brief The residual with which flow of the tree could come over an edge: towards
   * the neighbour for the source's tree, from the neighbour for the sink's.
   */
  int
  away(const Node& node, int direction, Tree tree) const
  {
    return tree == SOURCE ? node.residual[direction]
                          : two_capacities_ - node.residual[direction];
  }

  void
  setUp(const GridShape& shape, const std::vector<std::int16_t>& gain);
  void
  pushDirectly();
  void
  plantTrees();
  void
  activate(Index i);
  Index
  nextActive();
  int
  grow(Index i);
  void
  augment(Index i, int direction);
  int
  bottleneckTo(Index i, int limit) const;
  void
  pushTo(Index i, int amount);
  void
  makeOrphan(Index i);
  void
  adoptOrphans();
  void
  adopt(Index i);
  int
  distanceToTerminal(Index i) const;
  void
  release(Index i);

  std::vector<Node> nodes_;
  std::array<Index, 6> offset_;
  int capacity_;
  int two_capacities_;
  std::int64_t flow_ = 0;
  std::int32_t time_ = 0;
  Index first_ = none; // queue of active nodes
  Index last_ = none;
  std::vector<Index> orphans_;
};

} // namespace indoor
} // namespace pcl
