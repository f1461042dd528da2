/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

/** \brief An office floor as occupied voxels of 20 cm: rows of rooms along corridors,
 * doors, windows, furniture, surfaces with a tenth of their voxels not seen, and free
 * space around the house. REQUIRES: at least 30 x 30 x 10 voxels.
 */
inline pcl::indoor::VoxelMap<std::uint8_t>
officeFloor(int nx, int ny, int nz)
{
  constexpr int around = 8;
  constexpr int room_x = 24;
  constexpr int room_y = 27;
  std::mt19937 rng(61);
  pcl::indoor::VoxelMap<std::uint8_t> grid;
  grid.shape = {nx, ny, nz};
  grid.voxel_size = 0.2;
  grid.values.assign(grid.shape.size(), 0);
  const int floor = 1;
  const int ceiling = nz - 2;
  for (int x = around; x < nx - around; ++x)
    for (int y = around; y < ny - around; ++y) {
      const int u = (x - around) % room_x;
      const int v = (y - around) % room_y;
      const bool outer =
          x == around || y == around || x == nx - around - 1 || y == ny - around - 1;
      const bool wall =
          outer || u == 0 || v == 0 || v == 9; // every 9 voxels a corridor
      for (int z = floor; z <= ceiling; ++z) {
        const bool door = !outer && z < floor + 10 && (u == 12 || u == 13 || u == 14);
        const bool window = outer && z > floor + 4 && z < floor + 11 && u % 12 > 4;
        const bool surface = z == floor || z == ceiling || (wall && !door && !window);
        grid.at(x, y, z) = surface && rng() % 10 != 0;
      }
    }
  const unsigned pieces = static_cast<unsigned>(nx) * ny / 60;
  for (unsigned piece = 0; piece < pieces; ++piece) {
    const int x = around + 1 + static_cast<int>(rng() % (nx - 2 * around - 6));
    const int y = around + 1 + static_cast<int>(rng() % (ny - 2 * around - 6));
    const int height = 2 + static_cast<int>(rng() % 7);
    for (int dx = 0; dx < 4; ++dx)
      for (int dy = 0; dy < 3; ++dy)
        for (int z = floor; z < std::min(floor + height, ceiling); ++z)
          grid.at(x + dx, y + dy, z) = 1;
  }
  return grid;
}

/** \brief Points in the occupied voxels, in the order of columns, with exact number. */
inline std::vector<Eigen::Vector3f>
pointsOf(const pcl::indoor::VoxelMap<std::uint8_t>& grid, std::size_t count)
{
  std::size_t occupied = 0;
  for (const auto value : grid.values)
    occupied += value;
  std::mt19937 rng(62);
  const auto within = [&] {
    return grid.voxel_size * static_cast<double>(rng() % 1000) / 1000.0;
  };
  std::vector<Eigen::Vector3f> points;
  std::size_t seen = 0;
  for (int x = 0; x < grid.shape.nx; ++x)
    for (int y = 0; y < grid.shape.ny; ++y)
      for (int z = 0; z < grid.shape.nz; ++z) {
        if (!grid.at(x, y, z))
          continue;
        ++seen;
        const Eigen::Vector3d low = grid.voxel_size * Eigen::Vector3d(x, y, z);
        while (points.size() < count * seen / occupied)
          points.push_back(
              (low + Eigen::Vector3d(within(), within(), within())).cast<float>());
      }
  return points;
}
