/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief An edge that asks for the same sign of two nodes, or for different ones. */
struct SignEdge {
  std::uint32_t source = 0;
  std::uint32_t target = 0;
  float weight = 0; ///< how strong; positive for the same sign, negative for different
};

/** \brief Choose signs of small energy: the summed strengths of the edges that they do
 * not satisfy.
 *
 * The least energy is a maximum cut, hard to find in general. Signs are found by
 * contraction: nodes that are each other's strongest neighbours become one, the weights
 * of edges that so become parallel are added up, and so on until no edge is left. Then
 * single signs are flipped while that lowers the energy. If signs exist that satisfy
 * all edges, as they do on a surface wherever it has two sides, the result is one of
 * these. Cost: about linear in the number of edges.
 * \param[in] edges between nodes 0 to node_count - 1; their order plays no part but for
 * ties and rounding
 * \param[out] component if not null, the connected component of each node, numbered
 * from 0 by first node; edges of weight 0, and edges that cancel each other out,
 * connect nothing
 * \return +1 or -1, one per node; the first node of a component has +1
 * \throws pcl::BadArgumentException if an edge leaves the graph
 */
PCL_INDOOR_EXPORTS std::vector<std::int8_t>
findSigns(std::size_t node_count,
          const std::vector<SignEdge>& edges,
          std::vector<std::uint32_t>* component = nullptr);

} // namespace pcl::indoor
