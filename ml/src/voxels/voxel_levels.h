/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Rows that are multiplied by the weights of one tap, and the rows to which
 * that is added. */
struct RowPairs {
  std::vector<std::uint32_t> from, to;
};

/** \brief Occupied voxels of one size, in the order of their keys. */
struct VoxelLevel {
  std::vector<std::uint64_t> keys;   ///< see voxelKey()
  std::array<RowPairs, 27> near;     ///< from a neighbour, x fastest, to a voxel
  std::array<RowPairs, 8> to_parent; ///< from a voxel to that of the next level
};

/** \brief What a network is told of a voxel: 1, height, offset of the centroid from the
 * middle. */
constexpr std::size_t voxel_inputs = 5;

/** \brief Levels that a network has at most. */
constexpr std::size_t most_voxel_levels = 6;

/** \brief The least coordinate of the first level: that of the last level is 1, and no
 * neighbour has one below 0. */
constexpr int least_coordinate = 1 << (most_voxel_levels - 1);

/** \brief Coordinates side by side, x lowest: neighbours in a row are neighbours in
 * order. Coordinates lie from 1 to 2^18 - 2. */
std::uint64_t
voxelKey(std::uint64_t x, std::uint64_t y, std::uint64_t z);

/** \brief Levels of voxels whose size doubles.
 * \param[in] keys ascending, each once; coordinates from least_coordinate on
 * \param[in] count at most most_voxel_levels
 */
std::vector<VoxelLevel>
voxelLevels(std::vector<std::uint64_t> keys, std::size_t count);

} // namespace pcl::indoor
