/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>

#include <array>
#include <cstdint>

namespace pcl::indoor {

/** \brief Directions of a 6-connected grid: +x, -x, +y, -y, +z, -z. */
inline int
opposite(int direction)
{
  return direction ^ 1;
}

/** \brief A grid cut into bricks of 4 x 4 x 4 voxels: each voxel is a bit of a 64-bit
 * word, so that one operation works on all voxels of a brick.
 *
 * Voxels are numbered brick by brick, so that neighbours are near in memory. Bricks at
 * the far ends may reach beyond the grid.
 */
class GridBricks {
public:
  using Index = std::uint32_t;
  using Bits = std::uint64_t;

  explicit GridBricks(const GridShape& shape);

  /** \brief The number of bricks. */
  std::size_t
  size() const
  {
    return shape_.size();
  }
  /** \brief The place of a voxel. */
  std::size_t
  index(int x, int y, int z) const
  {
    return shape_.index(x / 4, y / 4, z / 4) * 64 +
           static_cast<std::size_t>(x % 4 * 16 + y % 4 * 4 + z % 4);
  }
  /** \brief The lowest x, y and z of a brick. */
  std::array<int, 3>
  corner(Index brick) const
  {
    const auto column = static_cast<int>(brick) / shape_.nz;
    return {4 * (column / shape_.ny),
            4 * (column % shape_.ny),
            4 * (static_cast<int>(brick) % shape_.nz)};
  }
  /** \brief The neighbour of a voxel. REQUIRES: it lies in the grid. */
  Index
  neighbour(Index voxel, int direction) const
  {
    return voxel + steps_[direction][voxel % 64];
  }
  /** \brief The neighbour of a brick. REQUIRES: it lies in the grid. */
  Index
  brick(Index brick, int direction) const
  {
    return brick + brick_steps_[direction];
  }
  /** \brief Where voxels come to lie that move by one and stay in their brick. */
  static Bits
  within(Bits voxels, int direction)
  {
    const int stride = strides[direction / 2];
    return direction % 2 == 0 ? (voxels & ~last[direction / 2]) << stride
                              : (voxels & ~first[direction / 2]) >> stride;
  }
  /** \brief Where voxels come to lie that move by one into the next brick. */
  static Bits
  across(Bits voxels, int direction)
  {
    const int stride = strides[direction / 2];
    return direction % 2 == 0 ? (voxels & last[direction / 2]) >> 3 * stride
                              : (voxels & first[direction / 2]) << 3 * stride;
  }
  /** \brief The voxels at bricks' faces towards -x, -y, -z. */
  static constexpr Bits first[3] = {
      0x000000000000ffff, 0x000f000f000f000f, 0x1111111111111111};
  /** \brief The voxels at bricks' faces towards +x, +y, +z. */
  static constexpr Bits last[3] = {
      0xffff000000000000, 0xf000f000f000f000, 0x8888888888888888};

private:
  static constexpr int strides[3] = {16, 4, 1};

  GridShape shape_; // in bricks
  std::array<Index, 6> brick_steps_;
  std::array<std::array<Index, 64>, 6> steps_; // wrap around for negative ones
};

/** \brief Call a function with the number of each bit that is set, lowest first. */
template <typename Function>
void
forEachBit(GridBricks::Bits bits, Function function)
{
  for (; bits != 0; bits &= bits - 1)
    function(static_cast<GridBricks::Index>(__builtin_ctzll(bits)));
}

} // namespace pcl::indoor
