/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/ceiling_slab.h"

#include "rooms/dimensions.h"
#include "rooms/space/greatest_around.h"
#include "rooms/space/map_regions.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::indoor {
namespace {

PixelMap<int>
highestOccupied(const VoxelBits& occupancy, const VerticalRange& storey)
{
  const GridShape& shape = occupancy.shape;
  auto top = PixelMap<int>::filled(shape.nx, shape.ny, -1);
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y) {
      const int z = occupancy.column(x, y).highest(storey.begin, storey.end);
      top.at(x, y) = z >= storey.begin ? z : -1;
    }
  return top;
}

/** The share of the columns of a window whose top is about as high as the middle one's.
 */
double
shareOfLevel(const PixelMap<int>& top, int x, int y, int radius)
{
  int same = 0, all = 0;
  for (int u = std::max(0, x - radius); u <= std::min(top.nx - 1, x + radius); ++u)
    for (int v = std::max(0, y - radius); v <= std::min(top.ny - 1, y + radius); ++v) {
      ++all;
      same += std::abs(top.at(u, v) - top.at(x, y)) <= 1;
    }
  return static_cast<double>(same) / all;
}

/** Whether something occupied goes on up to the ceiling, in its column or one beside
 * it: a wall or a lintel does, the tread of a stair or a cabinet does not. */
bool
reachesUpTo(int ceiling, const VoxelBits& occupancy, int x, int y, int z)
{
  const GridShape& shape = occupancy.shape;
  const auto isOccupiedAround = [&](int layer) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, shape.nx - 1); ++u)
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, shape.ny - 1); ++v)
        if (occupancy.at(u, v, layer))
          return true;
    return false;
  };
  int gap = 0; // a single layer may be free where points are sparse
  for (++z; z < ceiling && gap < 2; ++z)
    gap = isOccupiedAround(z) ? 0 : gap + 1;
  return gap < 2;
}

/** Whether the ceiling beside a pixel is more than a voxel higher: there a column is no
 * part of a ceiling but of a wall that leans, which is thick seen from below. */
bool
isSteep(const PixelMap<int>& ceiling, std::size_t pixel)
{
  bool is_steep = false;
  forEachNeighbour(ceiling, pixel, Neighbours::Four, [&](std::size_t other) {
    is_steep |= ceiling.values[other] > ceiling.values[pixel] + 1;
  });
  return is_steep;
}

} // namespace

PixelMap<int>
ceilingLayers(const VoxelBits& occupancy,
              const VerticalRange& storey,
              const CeilingSlabOptions& options)
{
  const PixelMap<int> top = highestOccupied(occupancy, storey);
  const int radius = static_cast<int>( // a window need not be larger than the map
      std::lround(std::min(0.5 * options.window / occupancy.voxel_size,
                           static_cast<double>(std::max(top.nx, top.ny)))));
  PixelMap<int> ceiling = greatestAround(top, radius);

  const auto layers = [&](double length) {
    return voxelsIn(length, occupancy.voxel_size);
  };
  const int step = layers(options.step);
  const int headroom = storey.begin + layers(options.min_height);
  for (int x = 0; x < top.nx; ++x)
    for (int y = 0; y < top.ny; ++y) {
      const int own = top.at(x, y);
      int& layer = ceiling.at(x, y);
      if (own < 0 || own == layer)
        continue;
      if (own >= layer - step ||
          (own >= headroom && shareOfLevel(top, x, y, radius) > options.level_share))
        layer = own;
    }
  for (auto& layer : ceiling.values)
    if (layer >= 0 && layer < headroom)
      layer = storey.end - 1; // nothing above was seen
  return ceiling;
}

SlabLayers
slabLayers(const VoxelBits& occupancy,
           const VerticalRange& storey,
           const PixelMap<int>& ceiling,
           const CeilingSlabOptions& options)
{
  const auto layers = [&](double length) { // there are no more than the grid has
    return static_cast<int>(
        std::lround(std::min(length / occupancy.voxel_size + 0.01,
                             static_cast<double>(occupancy.shape.nz))));
  };
  const int least = std::max(2, layers(options.gap));
  const int greatest = std::max(least, layers(options.max_gap));
  const int depth = std::max(1, layers(options.depth));
  std::vector<std::size_t> occupied(greatest + depth + 1, 0);
  for (std::size_t i = 0; i < ceiling.size(); ++i) {
    if (isSteep(ceiling, i))
      continue;
    const auto column = occupancy.column(i);
    const int top = ceiling.values[i];
    for (int below = 0; below <= greatest + depth && top - below >= storey.begin;
         ++below)
      occupied[below] += column[top - below];
  }
  const std::size_t walls = *std::min_element(occupied.begin() + least, occupied.end());
  int first = least;
  while (first < greatest && occupied[first] > 1.15 * walls)
    ++first;
  return {first, first + depth - 1};
}

PixelMap<std::uint8_t>
blockedColumns(const VoxelBits& occupancy,
               const VerticalRange& storey,
               const PixelMap<int>& ceiling,
               const SlabLayers& slab)
{
  auto blocked = PixelMap<std::uint8_t>::filled(ceiling.nx, ceiling.ny, 0);
  for (int x = 0; x < ceiling.nx; ++x)
    for (int y = 0; y < ceiling.ny; ++y) {
      const int top = ceiling.at(x, y);
      const int bottom = std::max(storey.begin, top - slab.last);
      int z = std::min(top - slab.first, occupancy.shape.nz - 1);
      while (z >= bottom && !occupancy.at(x, y, z))
        --z;
      blocked.at(x, y) = z >= bottom && reachesUpTo(top, occupancy, x, y, z);
    }
  return blocked;
}

PixelMap<int>
seenTops(const VoxelBits& occupancy,
         const VerticalRange& storey,
         const PixelMap<int>& ceiling,
         const CeilingSlabOptions& options)
{
  constexpr double stretch = 0.4;   // metres, below and above the heads
  constexpr double less_seen = 0.8; // share of what is seen below
  const auto layers = [&](double length) {
    return voxelsIn(length, occupancy.voxel_size, 1);
  };
  const int heads = storey.begin + layers(options.min_height);
  const int below = std::max(storey.begin, heads - layers(stretch));
  const int end =
      std::min({heads + layers(stretch) + 1, storey.end, occupancy.shape.nz});
  if (heads + 1 >= end)
    return ceiling; // the storey is no higher
  std::vector<std::size_t> seen(end, 0);
  for (std::size_t i = 0; i < ceiling.size(); ++i)
    occupancy.column(i).forEachSet(below, end, [&](int z) { ++seen[z]; });
  // floors and ceilings, also those that were put in, fill single layers
  const auto least = [&](int first, int last) {
    return static_cast<double>(
        *std::min_element(seen.begin() + first, seen.begin() + last));
  };
  const bool is_less = least(heads + 1, end) < less_seen * least(below, heads);
  return is_less ? topsAtHeads(occupancy, storey, ceiling) : ceiling;
}

PixelMap<int>
topsAtHeads(const VoxelBits& occupancy,
            const VerticalRange& storey,
            const PixelMap<int>& ceiling)
{
  const int heads = voxelsIn(passage_height, occupancy.voxel_size, 1);
  PixelMap<int> tops = ceiling;
  for (auto& top : tops.values)
    top = std::min(top, storey.begin + heads);
  return tops;
}

void
removeSpecks(PixelMap<std::uint8_t>& blocked, int min_extent)
{
  forEachRegion(blocked, Neighbours::Eight, [&](const auto& part) {
    int lowest_x = blocked.nx, highest_x = -1, lowest_y = blocked.ny, highest_y = -1;
    for (const std::size_t pixel : part) {
      const int x = static_cast<int>(pixel / blocked.ny);
      const int y = static_cast<int>(pixel % blocked.ny);
      lowest_x = std::min(lowest_x, x);
      highest_x = std::max(highest_x, x);
      lowest_y = std::min(lowest_y, y);
      highest_y = std::max(highest_y, y);
    }
    if (highest_x - lowest_x + 1 < min_extent && highest_y - lowest_y + 1 < min_extent)
      for (const std::size_t pixel : part)
        blocked.values[pixel] = 0;
  });
}

} // namespace pcl::indoor
