/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/closed_surfaces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl {
namespace indoor {
namespace {

VoxelMap<std::uint8_t>
halved(const VoxelMap<std::uint8_t>& fine)
{
  VoxelMap<std::uint8_t> coarse;
  coarse.voxel_size = 2.0 * fine.voxel_size;
  coarse.shape = {
      (fine.shape.nx + 1) / 2, (fine.shape.ny + 1) / 2, (fine.shape.nz + 1) / 2};
  coarse.values.assign(coarse.shape.size(), 0);
  for (int x = 0; x < fine.shape.nx; ++x)
    for (int y = 0; y < fine.shape.ny; ++y) {
      const auto* from = &fine.values[fine.shape.index(x, y, 0)];
      auto* to = &coarse.values[coarse.shape.index(x / 2, y / 2, 0)];
      for (int z = 0; z < fine.shape.nz; ++z)
        to[z / 2] |= from[z];
    }
  return coarse;
}

double
occupiedCount(const VoxelMap<std::uint8_t>& grid)
{
  return static_cast<double>(std::count(grid.values.begin(), grid.values.end(), 1));
}

} // namespace

double
closedVoxelSize(const VoxelMap<std::uint8_t>& grid, double largest)
{
  constexpr double closed = 4.0; // voxels per voxel twice as large, or more with noise
  constexpr double enough = 3.0;
  constexpr double centimetre = 0.01;
  if (grid.values.empty() || grid.voxel_size >= largest)
    return grid.voxel_size;
  const auto share = [closed](double finer, double coarser) {
    return std::min(closed, finer / std::max(1.0, coarser));
  };
  double size = grid.voxel_size;
  VoxelMap<std::uint8_t> coarse = halved(grid);
  double count = occupiedCount(coarse);
  double filled = share(occupiedCount(grid), count);
  if (filled >= enough)
    return size;
  while (size < largest) {
    coarse = halved(coarse);
    const double next = occupiedCount(coarse);
    const double next_filled = share(count, next);
    if (next_filled >= enough) { // between the two, the share rises with the octave
      size *= std::exp2((enough - filled) / (next_filled - filled));
      break;
    }
    size *= 2.0;
    count = next;
    filled = next_filled;
  }
  const double rounded = centimetre * std::ceil(size / centimetre - 1e-9);
  return std::min(largest, rounded);
}

} // namespace indoor
} // namespace pcl
