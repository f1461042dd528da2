/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/greatest_around.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace pcl::indoor {
namespace {

/** The maximum over a window of 2 * radius + 1 values with a stride, by a sliding block
 * maximum (van Herk). */
void
slidingMaximum(int* values, int count, std::size_t stride, int radius)
{
  constexpr int none = std::numeric_limits<int>::min();
  const int block = 2 * radius + 1;
  const int padded = (count + 2 * radius + block - 1) / block * block;
  std::vector<int> forward(padded, none), backward(padded, none);
  const auto value = [&](int i) {
    const int k = i - radius;
    return k >= 0 && k < count ? values[k * stride] : none;
  };
  for (int i = 0; i < padded; ++i)
    forward[i] = i % block ? std::max(forward[i - 1], value(i)) : value(i);
  for (int i = padded - 1; i >= 0; --i)
    backward[i] = (i + 1) % block
                      ? std::max(i + 1 < padded ? backward[i + 1] : none, value(i))
                      : value(i);
  for (int i = 0; i < count; ++i)
    values[i * stride] = std::max(backward[i], forward[i + block - 1]);
}

} // namespace

PixelMap<int>
greatestAround(PixelMap<int> map, int radius)
{
  radius = std::min(radius, std::max(map.nx, map.ny));
  for (int x = 0; x < map.nx; ++x)
    slidingMaximum(&map.values[map.index(x, 0)], map.ny, 1, radius);
  for (int y = 0; y < map.ny; ++y)
    slidingMaximum(&map.values[map.index(0, y)], map.nx, map.ny, radius);
  return map;
}

} // namespace pcl::indoor
