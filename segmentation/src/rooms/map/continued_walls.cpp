/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/continued_walls.h"

#include "rooms/dimensions.h"

#include <cmath>

namespace pcl::indoor {
namespace {

using Blocked = PixelMap<std::uint8_t>;

/** The lines of a map along x or y. */
struct Lines {
  const Blocked& map;
  bool along_x;

  int
  count() const
  {
    return along_x ? map.ny : map.nx;
  }

  int
  length() const
  {
    return along_x ? map.nx : map.ny;
  }

  std::size_t
  index(int line, int place) const
  {
    return along_x ? map.index(place, line) : map.index(line, place);
  }

  /** Whether a pixel is set, or one to either side of the line. */
  bool
  isSetAround(int line, int place) const
  {
    return map.values[index(line, place)] ||
           (line > 0 && map.values[index(line - 1, place)]) ||
           (line + 1 < count() && map.values[index(line + 1, place)]);
  }
};

void
continueAlong(const Lines& high, const Lines& low, double least, Blocked& result)
{
  constexpr double enough = 0.3; // of a line; 0.15 takes rows of furniture for walls
  for (int line = 0; line < low.count(); ++line)
    for (int begin = 0, end = 0; begin < low.length(); begin = ++end) {
      int reaching = 0;
      for (; end < low.length(); ++end) {
        const bool is_high = high.isSetAround(line, end);
        if (!is_high && !low.isSetAround(line, end))
          break;
        reaching += is_high;
      }
      if (reaching < least || reaching < enough * (end - begin))
        continue;
      for (int place = begin; place < end; ++place) {
        const std::size_t i = low.index(line, place);
        result.values[i] |= low.map.values[i];
      }
    }
}

} // namespace

PixelMap<std::uint8_t>
continuedWalls(const PixelMap<std::uint8_t>& high,
               const PixelMap<std::uint8_t>& low,
               double pixel_size)
{
  const double least = // sides of high cabinets are shorter
      std::round(surroundings / pixel_size);
  PixelMap<std::uint8_t> walls = high;
  for (const bool along_x : {true, false})
    continueAlong({high, along_x}, {low, along_x}, least, walls);
  return walls;
}

} // namespace pcl::indoor
