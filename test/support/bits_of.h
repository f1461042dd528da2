/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_bits.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

/** \brief All bits of a grid, column by column. */
inline std::vector<bool>
bitsOf(const pcl::indoor::VoxelBits& grid)
{
  std::vector<bool> bits;
  for (std::size_t pixel = 0; pixel < grid.columns(); ++pixel)
    for (int z = 0; z < grid.shape.nz; ++z)
      bits.push_back(grid.column(pixel)[z]);
  return bits;
}

/** \brief The voxel that holds a place; it may lie outside the grid. */
inline Eigen::Vector3i
voxelAt(const pcl::indoor::VoxelBits& grid, const Eigen::Vector3d& place)
{
  return ((place - grid.origin) / grid.voxel_size).array().floor().cast<int>();
}
