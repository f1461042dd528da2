/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace indoor {

enum class Neighbours { Four, Eight };

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
    for (std::size_t next = 0; next < region.size(); ++next) {
      const int x = static_cast<int>(region[next] / map.ny);
      const int y = static_cast<int>(region[next] % map.ny);
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, map.nx - 1); ++u)
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, map.ny - 1); ++v) {
          if (neighbours == Neighbours::Four && u != x && v != y)
            continue;
          const std::size_t other = map.index(u, v);
          if (map.values[other] == value && !seen[other]) {
            seen[other] = 1;
            region.push_back(other);
          }
        }
    }
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
  std::vector<std::size_t> queue;
  for (std::size_t pixel = 0; pixel < map.size(); ++pixel)
    if (map.values[pixel] != Value{0})
      queue.push_back(pixel);
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const int x = static_cast<int>(queue[next] / map.ny);
    const int y = static_cast<int>(queue[next] % map.ny);
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      if (!map.contains(x + dx, y + dy))
        continue;
      const std::size_t other = map.index(x + dx, y + dy);
      if (map.values[other] == Value{0} && may_pass(queue[next], other)) {
        map.values[other] = map.values[queue[next]];
        queue.push_back(other);
      }
    }
  }
}

} // namespace indoor
} // namespace pcl
