/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/space/grid_cut.h"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized" // inside Boost's solver
#endif
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/property_map/vector_property_map.hpp>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

/** \brief The edges of the flow network of a grid, sorted as Boost's compressed graph
 * wants them, with their capacities.
 */
struct GridNetwork {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::vector<int> capacities;

  void
  add(std::size_t from, std::size_t to, int capacity)
  {
    edges.emplace_back(from, to);
    capacities.push_back(capacity);
  }
};

/** \brief Source and sink are the last two nodes. */
inline GridNetwork
gridNetwork(const pcl::indoor::GridShape& shape,
            const std::vector<std::int16_t>& gain,
            int smoothness)
{
  const std::size_t source = shape.size();
  const std::size_t sink = source + 1;
  GridNetwork network;
  const auto link = [&](std::size_t v, int x, int y, int z) {
    if (shape.contains(x, y, z) &&
        gain[shape.index(x, y, z)] != pcl::indoor::GRID_CUT_EXCLUDED)
      network.add(v, shape.index(x, y, z), smoothness);
  };
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y)
      for (int z = 0; z < shape.nz; ++z) {
        const std::size_t v = shape.index(x, y, z);
        if (gain[v] == pcl::indoor::GRID_CUT_EXCLUDED)
          continue;
        link(v, x - 1, y, z);
        link(v, x, y - 1, z);
        link(v, x, y, z - 1);
        link(v, x, y, z + 1);
        link(v, x, y + 1, z);
        link(v, x + 1, y, z);
        if (gain[v] > 0)
          network.add(v, source, 0);
        if (gain[v] < 0)
          network.add(v, sink, -gain[v]);
      }
  for (std::size_t v = 0; v < source; ++v)
    if (gain[v] > 0)
      network.add(source, v, gain[v]);
  for (std::size_t v = 0; v < source; ++v)
    if (gain[v] < 0 && gain[v] != pcl::indoor::GRID_CUT_EXCLUDED)
      network.add(sink, v, 0);
  return network;
}

/** \brief cutGrid() by Boost's boykov_kolmogorov_max_flow: an oracle and a peer. */
inline pcl::indoor::GridCut
boostGridCut(const pcl::indoor::GridShape& shape,
             const std::vector<std::int16_t>& gain,
             int smoothness)
{
  using Graph = boost::compressed_sparse_row_graph<boost::directedS,
                                                   boost::no_property,
                                                   boost::no_property,
                                                   boost::no_property,
                                                   std::uint32_t,
                                                   std::uint32_t>;
  using Edge = boost::graph_traits<Graph>::edge_descriptor;
  const auto nodes = static_cast<std::uint32_t>(shape.size() + 2);
  const GridNetwork network = gridNetwork(shape, gain, smoothness);
  const Graph graph(boost::edges_are_sorted,
                    network.edges.begin(),
                    network.edges.end(),
                    nodes,
                    static_cast<std::uint32_t>(network.edges.size()));
  std::vector<Edge> reverse(network.edges.size());
  for (std::size_t e = 0; e < network.edges.size(); ++e) {
    const auto [from, to] = network.edges[e];
    const auto back = std::lower_bound(
        network.edges.begin(), network.edges.end(), std::make_pair(to, from));
    reverse[e] = Edge(to, static_cast<std::uint32_t>(back - network.edges.begin()));
  }
  std::vector<int> residual(network.edges.size());
  std::vector<Edge> predecessor(nodes);
  std::vector<boost::default_color_type> color(nodes);
  std::vector<long> distance(nodes);
  const auto edge_index = get(boost::edge_index, graph);
  const auto node_index = get(boost::vertex_index, graph);
  const auto by_edge = [&](auto& values) {
    return boost::make_iterator_property_map(values.begin(), edge_index);
  };
  const auto by_node = [&](auto& values) {
    return boost::make_iterator_property_map(values.begin(), node_index);
  };
  pcl::indoor::GridCut cut;
  cut.energy = boost::boykov_kolmogorov_max_flow(
      graph,
      boost::make_iterator_property_map(network.capacities.begin(), edge_index),
      by_edge(residual),
      by_edge(reverse),
      by_node(predecessor),
      by_node(color),
      by_node(distance),
      node_index,
      static_cast<std::uint32_t>(shape.size()),
      static_cast<std::uint32_t>(shape.size() + 1));
  const auto black = boost::color_traits<boost::default_color_type>::black();
  for (std::size_t v = 0; v < shape.size(); ++v)
    cut.inside.push_back(color[v] == black);
  return cut;
}
