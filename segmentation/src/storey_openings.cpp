/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "storey_openings.h"

#include "rectangle_sums.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pcl {
namespace indoor {

namespace {

using Mask = PixelMap<std::uint8_t>;

/** \brief Close holes that are narrower than twice the radius. */
PixelMap<float>
closed(const PixelMap<float>& map, int radius)
{
  PixelMap<float> grown = map;
  RectangleSums set(map);
  for (int x = 0; x < map.nx; ++x)
    for (int y = 0; y < map.ny; ++y)
      grown.at(x, y) = set.around(x, y, radius) > 0.0;
  PixelMap<float> result = map;
  RectangleSums grown_set(grown);
  for (int x = 0; x < map.nx; ++x)
    for (int y = 0; y < map.ny; ++y)
      result.at(x, y) =
          grown_set.around(x, y, radius) == grown_set.pixelsAround(x, y, radius);
  return result;
}

enum State : std::uint8_t { UNKNOWN, CUT, OPEN, OPEN_BELOW_CEILING };

/** \brief Whether a column has a free space at a level whose floor is clearly lower.
 * \return OPEN, or OPEN_BELOW_CEILING if there is no room for a storey above; UNKNOWN
 * if the column has no such space
 */
State
openness(const std::uint8_t* column, int nz, int level, int depth, int clearance)
{
  const int low = std::max(0, level - depth);
  const auto occupied = [](std::uint8_t value) { return value != 0; };
  if (level + 1 >= nz || std::any_of(column + low, column + level + 2, occupied) ||
      std::none_of(column, column + low, occupied))
    return UNKNOWN;
  const auto* ceiling = std::find_if(column + level + 2, column + nz, occupied);
  if (ceiling == column + nz)
    return UNKNOWN;
  return ceiling - (column + level) < clearance ? OPEN_BELOW_CEILING : OPEN;
}

/** \brief Turn the open regions smaller than a number of columns into cut ones. */
void
cutSmallOpenings(Mask& states, double min_columns)
{
  Mask seen = states;
  std::fill(seen.values.begin(), seen.values.end(), std::uint8_t{0});
  std::vector<std::size_t> region;
  for (std::size_t start = 0; start < states.values.size(); ++start) {
    if (states.values[start] != OPEN || seen.values[start])
      continue;
    region.assign(1, start);
    seen.values[start] = 1;
    for (std::size_t next = 0; next < region.size(); ++next) {
      const int x = static_cast<int>(region[next] / states.ny);
      const int y = static_cast<int>(region[next] % states.ny);
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        if (!states.contains(x + dx, y + dy))
          continue;
        const std::size_t other = states.index(x + dx, y + dy);
        if (states.values[other] == OPEN && !seen.values[other]) {
          seen.values[other] = 1;
          region.push_back(other);
        }
      }
    }
    if (static_cast<double>(region.size()) < min_columns)
      for (const std::size_t pixel : region)
        states.values[pixel] = CUT;
  }
}

/** \brief Give unknown columns (walls, outside) the state of the nearest known one. */
void
spread(Mask& states)
{
  std::vector<std::size_t> queue;
  for (std::size_t pixel = 0; pixel < states.values.size(); ++pixel)
    if (states.values[pixel] != UNKNOWN)
      queue.push_back(pixel);
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const int x = static_cast<int>(queue[next] / states.ny);
    const int y = static_cast<int>(queue[next] % states.ny);
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      if (!states.contains(x + dx, y + dy))
        continue;
      const std::size_t other = states.index(x + dx, y + dy);
      if (states.values[other] == UNKNOWN) {
        states.values[other] = states.values[queue[next]];
        queue.push_back(other);
      }
    }
  }
}

} // namespace

PixelMap<std::uint8_t>
openColumns(const VoxelGrid<std::uint8_t>& occupancy,
            const PixelMap<float>& slab,
            int level,
            const StoreyOptions& options)
{
  const GridShape& shape = occupancy.shape;
  const double size = occupancy.voxel_size;
  const auto whole = closed(slab, static_cast<int>(std::lround(options.bridge / size)));
  constexpr double min_depth = 0.5; // of a floor below the level, metres
  const int depth = static_cast<int>(std::lround(min_depth / size));
  const int clearance = static_cast<int>(std::lround(options.min_clearance / size));
  Mask states;
  states.nx = shape.nx;
  states.ny = shape.ny;
  states.values.assign(states.size(), UNKNOWN);
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y)
      states.at(x, y) = whole.at(x, y) > 0.0f
                            ? CUT
                            : openness(&occupancy.values[shape.index(x, y, 0)],
                                       shape.nz,
                                       level,
                                       depth,
                                       clearance);
  cutSmallOpenings(states, options.min_opening_area / (size * size));
  for (auto& state : states.values)
    state = state == OPEN_BELOW_CEILING ? OPEN : State{state};
  spread(states);
  for (auto& state : states.values)
    state = state == OPEN;
  return states;
}

} // namespace indoor
} // namespace pcl
