/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/unseen_sides.h"

#include "rooms/dimensions.h"
#include "rooms/space/enclosure.h"
#include "rooms/space/greatest_around.h"
#include "rooms/space/nearest_sites.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::indoor {
namespace {

/** Where the walls around each column begin and end, layers. */
struct WallEnds {
  PixelMap<int> low, high;
  PixelMap<std::uint8_t> is_near; ///< whether a wall is
};

/** The ends of the columns that are as high as a person, carried to the others: a
 * cupboard stands near to its wall. */
WallEnds
wallEnds(const VoxelMap<std::uint8_t>& occupancy)
{
  constexpr double near_wall = 2.0; // metres: farther off, the ground may be elsewhere
  const GridShape& shape = occupancy.shape;
  const int person = voxelsIn(standing_height, occupancy.voxel_size);
  const int radius = voxelsIn(surroundings, occupancy.voxel_size);
  auto walls = PixelMap<std::uint8_t>::filled(shape.nx, shape.ny, 0);
  auto negative_low = PixelMap<int>::filled(shape.nx, shape.ny, -shape.nz); // no wall
  auto high = PixelMap<int>::filled(shape.nx, shape.ny, -1);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const auto* column = &occupancy.values[i * shape.nz];
    int first = 0, last = shape.nz - 1;
    while (first < shape.nz && !column[first])
      ++first;
    while (last >= 0 && !column[last])
      --last;
    walls.values[i] = last - first >= person;
    if (walls.values[i]) {
      negative_low.values[i] = -first;
      high.values[i] = last;
    }
  }
  const PixelMap<int> negative_lowest = greatestAround(negative_low, radius);
  const PixelMap<int> highest = greatestAround(high, radius);
  const NearestSites nearest = nearestSites(walls);
  WallEnds ends{high, high, walls};
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const std::int32_t site = nearest.site.values[i];
    const double away = occupancy.voxel_size *
                        std::sqrt(std::max(0, nearest.squared_distance.values[i]));
    ends.is_near.values[i] = site >= 0 && away <= near_wall;
    ends.low.values[i] = site < 0 ? shape.nz : -negative_lowest.values[site];
    ends.high.values[i] = site < 0 ? -1 : highest.values[site];
  }
  return ends;
}

/** One of the two sides: floors or ceilings. */
struct Side {
  int inwards;          ///< 1 = up from the floor, -1 = down from the ceiling
  double inside;        ///< how far from the walls' ends is looked, metres
  std::uint8_t seen;    ///< the bit of what is looked for
  std::uint8_t instead; ///< the bit that tells without walls that it is there, or 0
};

/** How each voxel is enclosed, and the bits of one that walls enclose. */
struct Bits {
  const VoxelMap<std::uint8_t>& of;
  std::uint8_t walls;
};

/** Whether a voxel and those beside it are free: the hollow of a wall, which no scanner
 * looks into, is narrower. */
bool
isClear(const VoxelMap<std::uint8_t>& occupancy, int x, int y, int z)
{
  for (int u = x - 1; u <= x + 1; ++u)
    for (int v = y - 1; v <= y + 1; ++v)
      if (!occupancy.shape.contains(u, v, z) || occupancy.at(u, v, z))
        return false;
  return true;
}

/** Look for a side where the walls end.
 * \param[out] missing the voxels in which it should be
 * \return the share of the columns between walls that have it, of those that somebody
 * looked into
 */
double
lookFor(const Side& side,
        const WallEnds& walls,
        const VoxelMap<std::uint8_t>& occupancy,
        const Bits& bits,
        std::vector<std::size_t>& missing)
{
  const int step = voxelsIn(side.inside, occupancy.voxel_size);
  const PixelMap<int>& ends = side.inwards > 0 ? walls.low : walls.high;
  std::size_t between = 0, either = 0, seen = 0;
  for (int x = 0; x < ends.nx; ++x)
    for (int y = 0; y < ends.ny; ++y) {
      const int z = ends.at(x, y) + side.inwards * step;
      if (!occupancy.shape.contains(x, y, z))
        continue;
      const std::uint8_t bit = bits.of.at(x, y, z);
      const bool is_between = (bit & bits.walls) == bits.walls;
      const bool is_seen = (bit & side.seen) != 0;
      if (is_between && walls.is_near.at(x, y) && isClear(occupancy, x, y, z)) {
        ++between;
        either += (bit & (ENCLOSED_ABOVE | ENCLOSED_BELOW)) != 0;
        seen += is_seen;
      }
      if (!is_seen && (is_between || (bit & side.instead) != 0))
        missing.push_back(occupancy.shape.index(x, y, ends.at(x, y)));
    }
  // Up to half may be courtyards, shafts, and blocks between corridors.
  const std::size_t looked_into = std::max(either, between / 2);
  return looked_into > 0 ? static_cast<double>(seen) / static_cast<double>(looked_into)
                         : 1.0;
}

} // namespace

UnseenSides
findUnseenSides(const VoxelMap<std::uint8_t>& occupancy,
                const VoxelMap<std::uint8_t>& bits,
                int direction_count)
{
  constexpr double above_floor = 0.4; // metres: lower objects stand on it
  constexpr double below_slope = 1.2; // metres: so much roofs may fall within one
  UnseenSides sides;
  if (occupancy.values.empty() || direction_count == 0)
    return sides;
  const WallEnds ends = wallEnds(occupancy);
  const Bits between{bits,
                     static_cast<std::uint8_t>(((1 << direction_count) - 1) *
                                               ENCLOSED_ALONG_DIRECTION)};
  sides.ceiling_seen = lookFor(
      {-1, below_slope, ENCLOSED_ABOVE, 0}, ends, occupancy, between, sides.ceiling);
  const std::uint8_t ceiling = sides.ceilingIsSeen() ? ENCLOSED_ABOVE : 0;
  sides.floor_seen = lookFor(
      {1, above_floor, ENCLOSED_BELOW, ceiling}, ends, occupancy, between, sides.floor);
  if (sides.ceilingIsMostlySeen())
    sides.ceiling.clear();
  if (sides.floorIsSeen())
    sides.floor.clear();
  return sides;
}

void
closeUnseenSides(const InteriorSpace& space, VoxelBits& grid)
{
  const GridShape& coarse = space.occupancy.shape;
  const int factor = space.factor;
  const auto fill = [&](std::size_t voxel, int layer) {
    const int z = std::min(static_cast<int>(voxel % coarse.nz) * factor + layer,
                           grid.shape.nz - 1);
    const int x = static_cast<int>(voxel / coarse.nz / coarse.ny) * factor;
    const int y = static_cast<int>(voxel / coarse.nz % coarse.ny) * factor;
    for (int u = x; u < std::min(x + factor, grid.shape.nx); ++u)
      for (int v = y; v < std::min(y + factor, grid.shape.ny); ++v)
        grid.set(u, v, z);
  };
  for (const std::size_t voxel : space.unseen.floor)
    fill(voxel, 0);
  for (const std::size_t voxel : space.unseen.ceiling)
    fill(voxel, factor - 1);
}

} // namespace pcl::indoor
