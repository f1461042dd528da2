/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "grid_cut_solver.h"

#include <pcl/segmentation/grid_cut.h>

#include <algorithm>
#include <limits>

namespace pcl {
namespace indoor {

GridCutSolver::GridCutSolver(const GridShape& shape,
                             const std::vector<std::int16_t>& gain,
                             int smoothness)
: nodes_(gain.size())
, capacity_(smoothness)
, two_capacities_(2 * smoothness)
{
  const Index x_step = static_cast<Index>(shape.ny) * shape.nz;
  const Index y_step = shape.nz;
  offset_ = {x_step, Index{0} - x_step, y_step, Index{0} - y_step, 1, ~Index{0}};
  setUp(shape, gain);
}

void
GridCutSolver::setUp(const GridShape& shape, const std::vector<std::int16_t>& gain)
{
  std::size_t v = 0;
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y)
      for (int z = 0; z < shape.nz; ++z, ++v) {
        Node& node = nodes_[v];
        node.stamp = 0;
        node.distance = 1;
        node.next = none;
        node.parent = terminal;
        node.tree = FREE;
        node.links = 0;
        node.excess = 0;
        std::fill_n(node.residual, 6, std::int16_t{0});
        if (gain[v] == GRID_CUT_EXCLUDED)
          continue;
        node.excess = gain[v];
        if (capacity_ == 0)
          continue;
        const std::array<bool, 6> in_grid = {
            x + 1 < shape.nx, x > 0, y + 1 < shape.ny, y > 0, z + 1 < shape.nz, z > 0};
        for (int d = 0; d < 6; ++d)
          if (in_grid[d] &&
              gain[neighbour(static_cast<Index>(v), d)] != GRID_CUT_EXCLUDED) {
            node.links = static_cast<std::uint8_t>(node.links | 1 << d);
            node.residual[d] = static_cast<std::int16_t>(capacity_);
          }
      }
}

/** \brief Flow over a single edge of the grid needs no trees. */
void
GridCutSolver::pushDirectly()
{
  for (Index i = 0; i < nodes_.size(); ++i) {
    Node& node = nodes_[i];
    for (int d = 0; d < 6 && node.excess > 0; ++d) {
      if (!(node.links >> d & 1))
        continue;
      Node& other = nodes_[neighbour(i, d)];
      if (other.excess >= 0)
        continue;
      const int amount =
          std::min({node.excess, -other.excess, static_cast<int>(node.residual[d])});
      node.excess -= amount;
      other.excess += amount;
      node.residual[d] = static_cast<std::int16_t>(node.residual[d] - amount);
      other.residual[opposite(d)] =
          static_cast<std::int16_t>(other.residual[opposite(d)] + amount);
      flow_ += amount;
    }
  }
}

/** \brief Every node with something left is a root; only those that can grow or meet
 * the other tree need to be looked at.
 */
void
GridCutSolver::plantTrees()
{
  for (Node& node : nodes_)
    node.tree = node.excess > 0 ? SOURCE : node.excess < 0 ? SINK : FREE;
  for (Index i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    if (node.tree == FREE)
      continue;
    for (int d = 0; d < 6; ++d)
      if ((node.links >> d & 1) && away(node, d, node.tree) > 0 &&
          nodes_[neighbour(i, d)].tree != node.tree) {
        activate(i);
        break;
      }
  }
}

void
GridCutSolver::activate(Index i)
{
  if (nodes_[i].next != none)
    return;
  if (last_ == none)
    first_ = i;
  else
    nodes_[last_].next = i;
  last_ = i;
  nodes_[i].next = i;
}

GridCutSolver::Index
GridCutSolver::nextActive()
{
  while (first_ != none) {
    const Index i = first_;
    if (nodes_[i].next == i)
      first_ = last_ = none;
    else
      first_ = nodes_[i].next;
    nodes_[i].next = none;
    if (nodes_[i].tree != FREE)
      return i;
  }
  return none;
}

std::int64_t
GridCutSolver::run()
{
  pushDirectly();
  plantTrees();
  for (Index i = nextActive(); i != none; i = nextActive()) {
    // A node that met the other tree stays at work until it cannot grow any more.
    while (nodes_[i].tree != FREE) {
      const int direction = grow(i);
      if (direction < 0)
        break;
      ++time_;
      augment(i, direction);
      adoptOrphans();
    }
  }
  return flow_;
}

/** \brief Take free neighbours into the tree of a node.
 * \return the direction in which the other tree was met, or -1
 */
int
GridCutSolver::grow(Index i)
{
  const Node& node = nodes_[i];
  for (int d = 0; d < 6; ++d) {
    if (!(node.links >> d & 1) || away(node, d, node.tree) <= 0)
      continue;
    const Index j = neighbour(i, d);
    Node& other = nodes_[j];
    if (other.tree == FREE) {
      other.tree = node.tree;
      activate(j);
    }
    else if (other.tree != node.tree)
      return d;
    else if (other.stamp > node.stamp || other.distance <= node.distance)
      continue; // else this way to the terminal is shorter
    other.parent = static_cast<std::uint8_t>(opposite(d));
    other.stamp = node.stamp;
    other.distance = node.distance + 1;
  }
  return -1;
}

/** \brief The most that fits through the tree between a node and its terminal. */
int
GridCutSolver::bottleneckTo(Index i, int limit) const
{
  for (;;) {
    const Node& node = nodes_[i];
    if (node.parent == terminal)
      return std::min(limit, std::abs(node.excess));
    const Index j = neighbour(i, node.parent);
    // Flow comes from the source's side and leaves to the sink's.
    limit = std::min(
        limit, away(nodes_[j], opposite(node.parent), static_cast<Tree>(node.tree)));
    i = j;
  }
}

/** \brief Push through the tree; edges that are full make orphans. */
void
GridCutSolver::pushTo(Index i, int amount)
{
  for (;;) {
    Node& node = nodes_[i];
    const int sign = node.tree == SOURCE ? 1 : -1;
    if (node.parent == terminal) {
      node.excess -= sign * amount;
      if (node.excess == 0)
        makeOrphan(i);
      return;
    }
    const int d = node.parent;
    const Index j = neighbour(i, d);
    node.residual[d] = static_cast<std::int16_t>(node.residual[d] + sign * amount);
    std::int16_t& back = nodes_[j].residual[opposite(d)];
    back = static_cast<std::int16_t>(back - sign * amount);
    if (away(nodes_[j], opposite(d), node.tree) == 0)
      makeOrphan(i);
    i = j;
  }
}

void
GridCutSolver::augment(Index i, int direction)
{
  const Index j = neighbour(i, direction);
  int amount = away(nodes_[i], direction, nodes_[i].tree);
  amount = bottleneckTo(j, bottleneckTo(i, amount));
  const int sign = nodes_[i].tree == SOURCE ? 1 : -1;
  std::int16_t& there = nodes_[i].residual[direction];
  std::int16_t& back = nodes_[j].residual[opposite(direction)];
  there = static_cast<std::int16_t>(there - sign * amount);
  back = static_cast<std::int16_t>(back + sign * amount);
  pushTo(i, amount);
  pushTo(j, amount);
  flow_ += amount;
}

void
GridCutSolver::makeOrphan(Index i)
{
  nodes_[i].parent = orphan;
  orphans_.push_back(i);
}

void
GridCutSolver::adoptOrphans()
{
  for (std::size_t next = 0; next < orphans_.size(); ++next)
    adopt(orphans_[next]);
  orphans_.clear();
}

/** \brief Edges between a node and its terminal, or a large number if there is an
 * orphan on the way.
 */
int
GridCutSolver::distanceToTerminal(Index i) const
{
  int distance = 0;
  for (;;) {
    const Node& node = nodes_[i];
    if (node.stamp == time_)
      return distance + node.distance;
    if (node.parent == terminal)
      return distance + 1;
    if (node.parent == orphan)
      return std::numeric_limits<int>::max();
    ++distance;
    i = neighbour(i, node.parent);
  }
}

/** \brief Find the orphan a new parent close to the terminal, or set it free. */
void
GridCutSolver::adopt(Index i)
{
  Node& node = nodes_[i];
  int best = std::numeric_limits<int>::max();
  for (int d = 0; d < 6; ++d) {
    if (!(node.links >> d & 1))
      continue;
    Index j = neighbour(i, d);
    if (nodes_[j].tree != node.tree || away(nodes_[j], opposite(d), node.tree) <= 0)
      continue;
    int distance = distanceToTerminal(j);
    if (distance == std::numeric_limits<int>::max())
      continue;
    if (distance < best) {
      best = distance;
      node.parent = static_cast<std::uint8_t>(d);
    }
    for (; nodes_[j].stamp != time_; j = neighbour(j, nodes_[j].parent)) {
      nodes_[j].stamp = time_; // so that no node is passed twice
      nodes_[j].distance = distance--;
      if (nodes_[j].parent == terminal)
        break;
    }
  }
  if (best == std::numeric_limits<int>::max()) {
    release(i);
    return;
  }
  node.stamp = time_;
  node.distance = best + 1;
}

/** \brief Take a node out of its tree; its children become orphans. */
void
GridCutSolver::release(Index i)
{
  Node& node = nodes_[i];
  for (int d = 0; d < 6; ++d) {
    if (!(node.links >> d & 1))
      continue;
    const Index j = neighbour(i, d);
    if (nodes_[j].tree != node.tree)
      continue;
    if (away(nodes_[j], opposite(d), node.tree) > 0)
      activate(j);
    if (nodes_[j].parent == opposite(d))
      makeOrphan(j);
  }
  node.tree = FREE;
}

} // namespace indoor
} // namespace pcl
