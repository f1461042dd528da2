/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/point_cells.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Reach all places that can be reached from some, step by step, the nearest
 * first. The cost is linear in the number of places and of their neighbours.
 * \param[in,out] reached where to start; then all places that were reached, in the
 * order in which they were
 * \param[in] for_each_neighbor for_each_neighbor(place, visit) calls visit(other) for
 * each neighbour of a place
 * \param[in] enter enter(other, from) tells whether the neighbour is reached; it must
 * be false for places that were reached before
 */
template <typename Place, typename ForEachNeighbor, typename Enter>
void
floodFill(std::vector<Place>& reached,
          const ForEachNeighbor& for_each_neighbor,
          const Enter& enter)
{
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const Place from = reached[next]; // reached may move in memory
    for_each_neighbor(from, [&](const Place& other) {
      if (enter(other, from))
        reached.push_back(other);
    });
  }
}

/** \brief The same over lists of neighbours. */
template <typename Enter>
void
floodFill(std::vector<std::uint32_t>& reached,
          const Adjacency& neighbors,
          const Enter& enter)
{
  floodFill(
      reached,
      [&](std::uint32_t place, const auto& visit) {
        for (const auto other : neighbors.of(place))
          visit(other);
      },
      enter);
}

} // namespace pcl::indoor
