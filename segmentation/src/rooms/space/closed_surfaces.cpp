/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/closed_surfaces.h"

#include "rooms/dimensions.h"
#include "rooms/space/distance_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace pcl::indoor {
namespace {

VoxelBits
halved(const VoxelBits& fine)
{
  VoxelBits coarse;
  coarse.voxel_size = 2.0 * fine.voxel_size;
  coarse.reset(
      {(fine.shape.nx + 1) / 2, (fine.shape.ny + 1) / 2, (fine.shape.nz + 1) / 2});
  for (int x = 0; x < fine.shape.nx; ++x)
    for (int y = 0; y < fine.shape.ny; ++y) {
      const auto column = fine.column(x, y);
      if (!column.any(0, fine.shape.nz))
        continue;
      for (int z = 0; z < fine.shape.nz; ++z)
        if (column[z])
          coarse.set(x / 2, y / 2, z / 2);
    }
  return coarse;
}

double
occupiedCount(const VoxelBits& grid)
{
  return static_cast<double>(grid.count());
}

/** The voxels around what stands upright: the grounds of a building say nothing of how
 * densely it was scanned. Nothing where they hardly matter. */
std::optional<VoxelBits>
withoutGrounds(const VoxelBits& grid)
{
  constexpr double grounds = 0.25; // of the columns; else they hardly matter
  const int person = voxelsIn(standing_height, grid.voxel_size);
  const int nz = grid.shape.nz;
  auto held = PixelMap<std::uint8_t>::filled(grid.shape.nx, grid.shape.ny, 0);
  PixelMap<std::uint8_t> walls = held;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const auto column = grid.column(i);
    const int first = column.lowest(0, nz), last = column.highest(0, nz);
    if (first == nz)
      continue;
    held.values[i] = 1;
    walls.values[i] = last - first >= person;
  }
  const auto squared = squaredDistanceMap(walls, 1);
  const double reach = std::pow(surroundings / grid.voxel_size, 2);
  std::size_t all = 0, far = 0;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    all += held.values[i];
    far += held.values[i] && squared.values[i] > reach;
  }
  if (far == all || static_cast<double>(far) <= grounds * static_cast<double>(all))
    return std::nullopt;
  VoxelBits near = grid;
  for (std::size_t i = 0; i < walls.size(); ++i)
    if (squared.values[i] > reach)
      near.clearColumn(i);
  return near;
}

/** How many of the 26 voxels around one are occupied. */
int
neighborsOf(const VoxelBits& grid, int x, int y, int z)
{
  int count = -1; // itself
  for (int u = std::max(0, x - 1); u <= std::min(grid.shape.nx - 1, x + 1); ++u)
    for (int v = std::max(0, y - 1); v <= std::min(grid.shape.ny - 1, y + 1); ++v) {
      const auto column = grid.column(u, v);
      for (int w = std::max(0, z - 1); w <= std::min(grid.shape.nz - 1, z + 1); ++w)
        count += column[w];
    }
  return count;
}

} // namespace

bool
hasHoles(const VoxelBits& grid)
{
  constexpr int few = 5; // neighbours: in a surface without holes there are eight
  constexpr double many = 0.05; // of the voxels: whole scans have up to 0.042
  constexpr int stride = 3;     // columns, for speed
  std::size_t all = 0, with_few = 0;
  for (int x = 0; x < grid.shape.nx; x += stride)
    for (int y = 0; y < grid.shape.ny; y += stride) {
      const auto column = grid.column(x, y);
      if (!column.any(0, grid.shape.nz))
        continue;
      for (int z = 0; z < grid.shape.nz; ++z)
        if (column[z]) {
          ++all;
          with_few += neighborsOf(grid, x, y, z) < few;
        }
    }
  return static_cast<double>(with_few) > many * static_cast<double>(all);
}

double
closedVoxelSize(const VoxelBits& all, double largest)
{
  constexpr double closed = 4.0; // voxels per voxel twice as large, or more with noise
  constexpr double enough = 3.0;
  constexpr double centimetre = 0.01;
  if (all.empty() || all.voxel_size >= largest)
    return all.voxel_size;
  const auto building = withoutGrounds(all);
  const VoxelBits& grid = building ? *building : all;
  const auto share = [closed](double finer, double coarser) {
    return std::min(closed, finer / std::max(1.0, coarser));
  };
  double size = grid.voxel_size;
  VoxelBits coarse = halved(grid);
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

} // namespace pcl::indoor
