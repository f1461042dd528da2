/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/exceptions.h>
#include <pcl/indoor/voxel_map.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief A bit per voxel of a regular grid with a place in space: an eighth of the
 * memory of a VoxelMap of bytes. Each vertical column is whole 64-bit words.
 */
class VoxelBits {
public:
  /** \brief The bits of a column, the lowest voxel first. Those of the grid must
   * outlive it. */
  class Column {
  public:
    explicit Column(const std::uint64_t* words)
    : words_(words)
    {}

    bool
    operator[](int z) const
    {
      return words_[z / 64] >> z % 64 & 1;
    }

    /** \brief Whether a bit is set in the layers begin ... end - 1. */
    bool
    any(int begin, int end) const
    {
      for (int z = begin; z < end; z = (z / 64 + 1) * 64) {
        const std::uint64_t bits = words_[z / 64] >> z % 64;
        const int count = std::min(end - z, 64 - z % 64);
        if (bits << (64 - count) != 0)
          return true;
      }
      return false;
    }

    /** \brief The lowest of the layers begin ... end - 1 whose bit is set; \a end if
     * none is. REQUIRES: begin >= 0. */
    int
    lowest(int begin, int end) const
    {
      for (int z = begin; z < end; z = (z / 64 + 1) * 64)
        if (const std::uint64_t bits = words_[z / 64] >> z % 64; bits != 0)
          return std::min(end, z + __builtin_ctzll(bits));
      return end;
    }

    /** \brief The highest of them; begin - 1 if none is set. REQUIRES: begin >= 0. */
    int
    highest(int begin, int end) const
    {
      for (int z = end - 1; z >= begin; z = z / 64 * 64 - 1)
        if (const std::uint64_t bits = words_[z / 64] << (63 - z % 64); bits != 0)
          return std::max(begin - 1, z - __builtin_clzll(bits));
      return begin - 1;
    }

    /** \brief Call visit(z) for each bit that is set in the layers begin ... end - 1,
     * the lowest first. */
    template <typename Visit>
    void
    forEachSet(int begin, int end, const Visit& visit) const
    {
      for (int z = begin; z < end; z = (z / 64 + 1) * 64) {
        const int count = std::min(end - z, 64 - z % 64);
        auto bits = words_[z / 64] >> z % 64 << (64 - count) >> (64 - count);
        for (; bits != 0; bits &= bits - 1)
          visit(z + __builtin_ctzll(bits));
      }
    }

  private:
    const std::uint64_t* words_;
  };

  GridShape shape; ///< that of the bits once reset() was called with it
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< lower corner of voxel
                                                    ///< (0, 0, 0), metres, local frame
  double voxel_size = 0.0;                          ///< edge length of a voxel, metres

  VoxelBits() = default;

  /** \brief The voxels of a map that are not 0.
   * \throws pcl::BadArgumentException if its values do not fill its shape */
  VoxelBits(const VoxelMap<std::uint8_t>& map)
  : origin(map.origin)
  , voxel_size(map.voxel_size)
  {
    if (map.values.size() != map.shape.size())
      PCL_THROW_EXCEPTION(BadArgumentException,
                          map.values.size() << " values do not fill a grid of "
                                            << map.shape.size() << " voxels.");
    reset(map.shape);
    const auto* value = map.values.data();
    for (std::size_t pixel = 0; pixel < columns(); ++pixel)
      for (int z = 0; z < shape.nz; ++z, ++value)
        words_[pixel * words_per_column_ + z / 64] |= std::uint64_t{*value != 0}
                                                      << z % 64;
  }

  /** \brief The same as a byte per voxel, 1 where its bit is set. */
  VoxelMap<std::uint8_t>
  bytes() const
  {
    VoxelMap<std::uint8_t> map{shape, origin, voxel_size, {}};
    map.values.resize(shape.size());
    auto* value = map.values.data();
    for (std::size_t pixel = 0; pixel < columns(); ++pixel) {
      const auto bits = column(pixel);
      for (int z = 0; z < shape.nz; ++z, ++value)
        *value = bits[z];
    }
    return map;
  }

  /** \brief Set the shape, and all bits to 0. */
  void
  reset(const GridShape& new_shape)
  {
    shape = new_shape;
    words_per_column_ = (shape.nz + 63) / 64;
    words_.assign(columns() * words_per_column_, 0);
  }

  /** \brief Whether there are no voxels. */
  bool
  empty() const
  {
    return words_.empty();
  }

  /** \brief The number of columns; their places are those in a PixelMap. */
  std::size_t
  columns() const
  {
    return static_cast<std::size_t>(shape.nx) * static_cast<std::size_t>(shape.ny);
  }

  /** \brief The bits of a column. REQUIRES: pixel < columns(). */
  Column
  column(std::size_t pixel) const
  {
    return Column(&words_[pixel * words_per_column_]);
  }

  Column
  column(int x, int y) const
  {
    return column(pixelAt(x, y));
  }

  /** \brief The bit of a voxel. REQUIRES: shape.contains(x, y, z). */
  bool
  at(int x, int y, int z) const
  {
    return column(x, y)[z];
  }

  /** \brief Set the bit of a voxel, of which others may be set by other threads at the
   * same time. REQUIRES: shape.contains(x, y, z). */
  void
  set(int x, int y, int z)
  {
    setIn(pixelAt(x, y), z);
  }

  /** \brief The number of bits that are set. */
  std::size_t
  count() const
  {
    std::size_t sum = 0;
    for (const std::uint64_t word : words_)
      sum += static_cast<std::size_t>(__builtin_popcountll(word));
    return sum;
  }

  /** \brief Set all bits of a column to 0. */
  void
  clearColumn(std::size_t pixel)
  {
    std::fill_n(words_.begin() + static_cast<std::ptrdiff_t>(pixel * words_per_column_),
                words_per_column_,
                std::uint64_t{0});
  }

  /** \brief The centre of a voxel in the local frame, metres. */
  Eigen::Vector3d
  center(int x, int y, int z) const
  {
    return origin + voxel_size * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5);
  }

private:
  std::size_t
  pixelAt(int x, int y) const
  {
    return static_cast<std::size_t>(x) * static_cast<std::size_t>(shape.ny) +
           static_cast<std::size_t>(y);
  }

  void
  setIn(std::size_t pixel, int z)
  {
    std::uint64_t& word = words_[pixel * words_per_column_ + z / 64];
    const std::uint64_t bit = std::uint64_t{1} << z % 64;
    std::uint64_t before;
#pragma omp atomic read
    before = word;
    if ((before & bit) != 0) // as mostly, and much faster
      return;
#pragma omp atomic
    word |= bit;
  }

  std::size_t words_per_column_ = 0;
  std::vector<std::uint64_t> words_;
};

} // namespace pcl::indoor
