/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief An undirected edge of a graph whose nodes are 0 ... n - 1. */
struct WeightedEdge {
  std::uint32_t source = 0;
  std::uint32_t target = 0;
  float weight = 0; ///< dissimilarity of the two nodes, not negative
};

/** \brief Segment a weighted graph by the method of Felzenszwalb and Huttenlocher (IJCV
 * 2004; Sec. 2.1.6.3, Eq. (2.14) to (2.17)). Equal weights are taken in the order of
 * (source, target), so the result does not depend on the order of the edges. Cost is
 * that of sorting the edges.
 * \param[in] node_count number of nodes
 * \param[in] edges undirected, between nodes 0 ... node_count - 1, in any order
 * \param[in] scale k of the paper, in the unit of the edge weights times nodes (>= 0);
 * larger gives larger segments
 * \param[in] min_segment_size C: smaller segments are merged into a neighbour, over
 * their lightest edge; in nodes, 1 merges none
 * \return the segment of each node; segments are numbered from 0 in the order of their
 * first node
 * \throws pcl::BadArgumentException if an edge leaves the graph, a weight is negative
 * or not finite, or the scale is
 */
PCL_INDOOR_EXPORTS std::vector<std::uint32_t>
segmentGraph(std::size_t node_count,
             std::vector<WeightedEdge> edges,
             float scale,
             std::uint32_t min_segment_size);

} // namespace pcl::indoor
