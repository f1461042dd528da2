/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief A border between two of the nodes 0 ... n - 1. */
struct Border {
  std::uint32_t source = 0;
  std::uint32_t target = 0;
  double cost = 0;   ///< evidence that an object ends here; low ones are joined first
  double length = 0; ///< weight of the cost in averages (> 0)
};

/** \brief Join nodes to segments, always over the border of lowest mean cost
 * (agglomeration with average linkage). The whole border decides, so that a few wrong
 * edges neither join two objects nor part one. Equal costs are taken in the order of
 * nodes. Cost is about n log n for n borders.
 * \param[in] node_count number of nodes
 * \param[in] borders undirected; costs of several between the same nodes are averaged
 * \param[in] threshold segments are joined while the mean cost of their common border
 * is not above it
 * \param[in] min_segment_size C: smaller segments are joined over their cheapest
 * border; nodes, 1 joins none
 * \return the segment of each node, numbered from 0 in the order of their first nodes
 * \throws pcl::BadArgumentException if a border leaves the graph, a length is not
 * positive, or a cost is not finite
 */
std::vector<std::uint32_t>
clusterByBorders(std::size_t node_count,
                 const std::vector<Border>& borders,
                 double threshold,
                 std::uint32_t min_segment_size);

} // namespace pcl::indoor
