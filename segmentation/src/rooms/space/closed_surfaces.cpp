/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/closed_surfaces.h"

#include "rooms/field/potential_field.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

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

/** The voxels around what stands upright: the grounds of a building say nothing of how
 * densely it was scanned. Nothing where they hardly matter. */
std::optional<VoxelMap<std::uint8_t>>
withoutGrounds(const VoxelMap<std::uint8_t>& grid)
{
  constexpr double high = 1.5;     // metres, as the clearance of storeys
  constexpr double nearby = 1.0;   // metres
  constexpr double grounds = 0.25; // of the columns; else they hardly matter
  const auto person = static_cast<std::ptrdiff_t>(std::lround(high / grid.voxel_size));
  const int nz = grid.shape.nz;
  PixelMap<std::uint8_t> held{grid.shape.nx, grid.shape.ny, {}};
  held.values.assign(held.size(), 0);
  PixelMap<std::uint8_t> walls = held;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const auto* column = &grid.values[i * nz];
    const auto* first = std::find(column, column + nz, 1);
    const auto* last = column + nz - 1;
    while (last > first && *last == 0)
      --last;
    held.values[i] = first != column + nz;
    walls.values[i] = last - first >= person;
  }
  const auto squared = squaredDistanceMap(walls, 1);
  const double reach = std::pow(nearby / grid.voxel_size, 2);
  std::size_t all = 0, far = 0;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    all += held.values[i];
    far += held.values[i] && squared.values[i] > reach;
  }
  if (far == all || static_cast<double>(far) <= grounds * static_cast<double>(all))
    return std::nullopt;
  VoxelMap<std::uint8_t> near = grid;
  for (std::size_t i = 0; i < walls.size(); ++i)
    if (squared.values[i] > reach)
      std::fill_n(near.values.begin() + i * nz, nz, std::uint8_t{0});
  return near;
}

} // namespace

double
closedVoxelSize(const VoxelMap<std::uint8_t>& all, double largest)
{
  constexpr double closed = 4.0; // voxels per voxel twice as large, or more with noise
  constexpr double enough = 3.0;
  constexpr double centimetre = 0.01;
  if (all.values.empty() || all.voxel_size >= largest)
    return all.voxel_size;
  const auto building = withoutGrounds(all);
  const VoxelMap<std::uint8_t>& grid = building ? *building : all;
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
