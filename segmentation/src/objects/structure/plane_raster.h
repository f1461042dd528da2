/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/room_structure.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

namespace pcl::indoor {

/** The cells of a plane: which hold points of it, and behind which something lies. They
 * are kept in tiles, because parts of one plane may lie kilometres apart.
 */
class PlaneRaster {
public:
  PlaneRaster(const SurfaceVoxels& voxels,
              const StructurePlane& plane,
              double cell_size)
  : plane_(plane)
  , u_(plane.normal.unitOrthogonal())
  , v_(plane.normal.cross(u_))
  , cell_size_(cell_size)
  {
    low_.setConstant(std::numeric_limits<double>::infinity());
    for (const auto i : plane.voxels)
      low_ = low_.min(placeOf(voxels.centroids[i].cast<double>()));
    for (const auto i : plane.voxels) {
      const auto [tile, cell] = cellOf(voxels.centroids[i].cast<double>());
      tiles_[tile][cell] |= covered;
    }
  }

  /** Note what lies farther than the margin behind the plane. */
  void
  look(const SurfaceVoxels& voxels, double margin)
  {
    for (const auto& centroid : voxels.centroids) {
      const Eigen::Vector3d position = centroid.cast<double>();
      if (!(plane_.offset - plane_.normal.dot(position) > margin))
        continue;
      const auto [number, cell] = cellOf(position);
      const auto tile = tiles_.find(number);
      if (tile != tiles_.end())
        tile->second[cell] |= behind;
    }
  }

  /** The share of the plane with nothing behind it. */
  double
  freeShare() const
  {
    std::size_t all = 0, free = 0;
    for (const auto& tile : tiles_)
      for (const auto cell : tile.second)
        if (cell & covered) {
          ++all;
          free += (cell & behind) == 0;
        }
    return static_cast<double>(free) /
           static_cast<double>(std::max<std::size_t>(all, 1));
  }

private:
  enum : std::uint8_t { covered = 1, behind = 2 };
  static constexpr std::int64_t tile_size = 64; // cells in each direction
  using Tile = std::array<std::uint8_t, tile_size * tile_size>;

  Eigen::Array2d
  placeOf(const Eigen::Vector3d& position) const
  {
    return {u_.dot(position), v_.dot(position)};
  }

  /** The number of a cell's tile, and its place there. */
  std::pair<std::int64_t, std::size_t>
  cellOf(const Eigen::Vector3d& position) const
  {
    const Eigen::Array2d place = ((placeOf(position) - low_) / cell_size_).floor();
    const auto x = static_cast<std::int64_t>(place.x());
    const auto y = static_cast<std::int64_t>(place.y());
    const auto row = (x % tile_size + tile_size) % tile_size;
    const auto column = (y % tile_size + tile_size) % tile_size;
    return {(x - row) / tile_size * (std::int64_t{1} << 32) + (y - column) / tile_size,
            static_cast<std::size_t>(row * tile_size + column)};
  }

  const StructurePlane& plane_;
  Eigen::Vector3d u_, v_;
  double cell_size_;
  Eigen::Array2d low_;
  std::unordered_map<std::int64_t, Tile> tiles_;
};

} // namespace pcl::indoor
