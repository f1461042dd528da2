/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/flood_fill.h>
#include <pcl/indoor/voxel_map.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::indoor {

enum class Neighbours { Four, Eight };

/** \brief Call visit(other) for each pixel beside one, in the order of the map. */
template <typename Value, typename Visit>
void
forEachNeighbour(const PixelMap<Value>& map,
                 std::size_t pixel,
                 Neighbours neighbours,
                 const Visit& visit)
{
  const int x = static_cast<int>(pixel / map.ny);
  const int y = static_cast<int>(pixel % map.ny);
  for (int u = std::max(x - 1, 0); u <= std::min(x + 1, map.nx - 1); ++u)
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, map.ny - 1); ++v)
      if ((u != x || v != y) && (neighbours == Neighbours::Eight || u == x || v == y))
        visit(map.index(u, v));
}

/** \brief The same as floodFill() asks for it. */
template <typename Value>
auto
neighboursIn(const PixelMap<Value>& map, Neighbours neighbours = Neighbours::Eight)
{
  return [&map, neighbours](std::size_t pixel, const auto& visit) {
    forEachNeighbour(map, pixel, neighbours, visit);
  };
}

/** \brief Call visit(pixels) for each connected region of pixels with the same value
 * other than 0, in the order of their first pixels. The region may be changed then.
 */
template <typename Value, typename Visitor>
void
forEachRegion(const PixelMap<Value>& map, Neighbours neighbours, const Visitor& visit)
{
  std::vector<std::uint8_t> seen(map.size(), 0);
  std::vector<std::size_t> region;
  for (std::size_t start = 0; start < map.size(); ++start) {
    const Value value = map.values[start];
    if (value == Value{0} || seen[start])
      continue;
    region.assign(1, start);
    seen[start] = 1;
    const auto enter = [&](std::size_t other, std::size_t) {
      return map.values[other] == value && !std::exchange(seen[other], 1);
    };
    floodFill(region, neighboursIn(map, neighbours), enter);
    visit(region);
  }
}

/** \brief Give the pixels with value 0 that of a near one, step by step over the sides
 * of pixels.
 * \param[in] may_pass asked whether a value may go from a pixel to the next
 */
template <typename Value, typename MayPass>
void
spreadValues(PixelMap<Value>& map, const MayPass& may_pass)
{
  std::vector<std::size_t> reached;
  for (std::size_t pixel = 0; pixel < map.size(); ++pixel)
    if (map.values[pixel] != Value{0})
      reached.push_back(pixel);
  floodFill(
      reached,
      [&](std::size_t pixel, const auto& visit) {
        const int x = static_cast<int>(pixel / map.ny);
        const int y = static_cast<int>(pixel % map.ny);
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
          if (map.contains(x + dx, y + dy))
            visit(map.index(x + dx, y + dy));
      },
      [&](std::size_t other, std::size_t from) {
        const bool goes = map.values[other] == Value{0} && may_pass(from, other);
        if (goes)
          map.values[other] = map.values[from];
        return goes;
      });
}

} // namespace pcl::indoor
