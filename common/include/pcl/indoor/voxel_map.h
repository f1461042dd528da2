/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief How many voxels a length takes, rounded.
 * \param[in] least the result is not less
 */
inline int
voxelsIn(double length, double voxel_size, int least = 0)
{
  return std::max(least, static_cast<int>(std::lround(length / voxel_size)));
}

/** \brief The index arithmetic of a regular grid, without a place in space.
 * x runs slowest and z fastest, so that a vertical column is contiguous in memory.
 */
struct GridShape {
  int nx = 0; ///< voxels along x
  int ny = 0; ///< voxels along y
  int nz = 0; ///< voxels along z

  /** \brief The number of voxels. */
  std::size_t
  size() const
  {
    return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) *
           static_cast<std::size_t>(nz);
  }

  /** \brief The place of a voxel in memory. REQUIRES: contains(x, y, z). */
  std::size_t
  index(int x, int y, int z) const
  {
    return (static_cast<std::size_t>(x) * static_cast<std::size_t>(ny) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(nz) +
           static_cast<std::size_t>(z);
  }

  /** \brief Whether a voxel lies in the grid. */
  bool
  contains(int x, int y, int z) const
  {
    return x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz;
  }
};

inline bool
operator==(const GridShape& a, const GridShape& b)
{
  return a.nx == b.nx && a.ny == b.ny && a.nz == b.nz;
}

inline bool
operator!=(const GridShape& a, const GridShape& b)
{
  return !(a == b);
}

/** \brief A value per voxel of a regular grid with a place in space. */
template <typename T>
struct VoxelMap {
  GridShape shape;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< lower corner of voxel
                                                    ///< (0, 0, 0), metres, local frame
  double voxel_size = 0.0;                          ///< edge length of a voxel, metres
  std::vector<T> values; ///< shape.size() of them, at shape.index(x, y, z)

  /** \brief The value of a voxel. REQUIRES: shape.contains(x, y, z). */
  T&
  at(int x, int y, int z)
  {
    return values[shape.index(x, y, z)];
  }

  const T&
  at(int x, int y, int z) const
  {
    return values[shape.index(x, y, z)];
  }
};

/** \brief A value per vertical column of a voxel grid; y runs fastest. */
template <typename T>
struct PixelMap {
  int nx = 0;            ///< pixels along x
  int ny = 0;            ///< pixels along y
  std::vector<T> values; ///< nx * ny of them, at index(x, y)

  /** \brief A map with one value everywhere. */
  static PixelMap
  filled(int nx, int ny, const T& value)
  {
    PixelMap map{nx, ny, {}};
    map.values.assign(map.size(), value);
    return map;
  }

  std::size_t
  size() const
  {
    return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny);
  }

  /** \brief The place of a pixel in memory. REQUIRES: contains(x, y). */
  std::size_t
  index(int x, int y) const
  {
    return static_cast<std::size_t>(x) * static_cast<std::size_t>(ny) +
           static_cast<std::size_t>(y);
  }

  bool
  contains(int x, int y) const
  {
    return x >= 0 && y >= 0 && x < nx && y < ny;
  }

  /** \brief The value of a pixel. REQUIRES: contains(x, y). */
  T&
  at(int x, int y)
  {
    return values[index(x, y)];
  }

  const T&
  at(int x, int y) const
  {
    return values[index(x, y)];
  }
};

} // namespace pcl::indoor
