/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/storeys/storey_openings.h"

#include "rooms/dimensions.h"
#include "rooms/space/greatest_around.h"
#include "rooms/space/map_regions.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pcl::indoor {

namespace {

using Mask = PixelMap<std::uint8_t>;

/** \brief Close holes that are narrower than twice the radius. */
PixelMap<int>
closed(PixelMap<int> map, int radius)
{
  const auto negate = [&map] {
    for (int& value : map.values)
      value = -value;
  };
  map = greatestAround(std::move(map), radius);
  negate();
  map = greatestAround(std::move(map), radius); // the least
  negate();
  return map;
}

enum State : std::uint8_t { UNKNOWN, CUT, OPEN, OPEN_BELOW_CEILING };

/** \brief Whether there is room for a storey in a column above a layer. */
bool
hasStoreyAbove(const VoxelBits::Column& column, int nz, int layer, int clearance)
{
  int free = 0;
  for (int z = layer; z < nz; ++z) {
    if (column[z] && free >= clearance)
      return true;
    free = column[z] ? 0 : free + 1;
  }
  return false;
}

/** \brief Whether a column has a free space at a level whose floor is clearly lower.
 * \return OPEN, or OPEN_BELOW_CEILING if there is no room for a storey above; UNKNOWN
 * if the column has no such space
 */
State
openness(const VoxelBits::Column& column, int nz, int level, int depth, int clearance)
{
  const int low = std::max(0, level - depth);
  if (level + 1 >= nz || column.any(low, level + 2) || !column.any(0, low))
    return UNKNOWN;
  if (!column.any(level + 2, nz))
    return UNKNOWN;
  return hasStoreyAbove(column, nz, level, clearance) ? OPEN : OPEN_BELOW_CEILING;
}

/** \brief Cut the open regions that are too small, columns.
 * \param[in] min_hall if there is room for a storey above
 * \param[in] min_room if not
 */
void
cutSmallOpenings(Mask& states, double min_hall, double min_room)
{
  forEachRegion(states, Neighbours::Four, [&](const auto& region) {
    const double least = states.values[region.front()] == OPEN ? min_hall : min_room;
    if (static_cast<double>(region.size()) < least)
      for (const std::size_t pixel : region)
        states.values[pixel] = CUT;
  });
}

/** \brief Cut the openings in the ceilings of rooms most of which lies below the slab:
 * these are galleries. A hall is open over most of its floor.
 * \param[in] low the layers right below the slab begin there, with lintels in them
 */
void
cutGalleries(const VoxelBits& occupancy, int low, int high, Mask& states)
{
  const GridShape& shape = occupancy.shape;
  Mask rooms = states;
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y)
      rooms.at(x, y) =
          states.at(x, y) != UNKNOWN &&
          !occupancy.column(x, y).any(std::max(0, low), std::max(0, high + 1));
  forEachRegion(rooms, Neighbours::Four, [&](const auto& room) {
    const auto open = std::count_if(room.begin(), room.end(), [&](std::size_t pixel) {
      return states.values[pixel] != CUT;
    });
    if (2 * static_cast<std::size_t>(open) >= room.size())
      return;
    for (const std::size_t pixel : room)
      states.values[pixel] = CUT;
  });
}

} // namespace

PixelMap<std::uint8_t>
openColumns(const VoxelBits& occupancy,
            const PixelMap<float>& slab,
            int level,
            const StoreyOptions& options)
{
  const GridShape& shape = occupancy.shape;
  const double size = occupancy.voxel_size;
  const auto whole =
      closed({slab.nx, slab.ny, {slab.values.begin(), slab.values.end()}},
             voxelsIn(options.bridge, size));
  const int depth = voxelsIn(thickest_wall, size); // of a floor below the level
  const int clearance = voxelsIn(options.min_clearance, size);
  auto states = Mask::filled(shape.nx, shape.ny, UNKNOWN);
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y)
      states.at(x, y) =
          whole.at(x, y) != 0
              ? CUT
              : openness(occupancy.column(x, y), shape.nz, level, depth, clearance);
  cutGalleries(occupancy,
               level - voxelsIn(thickest_wall + lintel_height, size),
               level - voxelsIn(thickest_wall, size),
               states);
  constexpr double largest_gap = 2.0; // in what was seen, m^2
  cutSmallOpenings(
      states, options.min_opening_area / (size * size), largest_gap / (size * size));
  for (auto& state : states.values)
    state = state == OPEN_BELOW_CEILING ? OPEN : State{state};
  // Unknown columns (walls, outside) go with the nearest known ones.
  spreadValues(states, [](std::size_t, std::size_t) { return true; });
  for (auto& state : states.values)
    state = state == OPEN;
  return states;
}

} // namespace pcl::indoor
