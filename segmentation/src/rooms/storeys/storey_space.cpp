/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/storeys/storey_space.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {
namespace {

/** Per column the layers of one storey. */
struct ColumnRanges {
  PixelMap<int> begin, end;
  int lowest, highest; // over all columns
};

ColumnRanges
columnRanges(const VoxelBits& grid, const Storeys& storeys, std::size_t k)
{
  const int nz = grid.shape.nz;
  const auto layerOf = [&](float height) { // a border lies in this layer
    const double layer = (height - grid.origin.z()) / grid.voxel_size;
    return static_cast<int>(std::clamp(std::floor(layer), -1.0, double(nz)));
  };
  const auto none = PixelMap<int>::filled(grid.shape.nx, grid.shape.ny, 0);
  ColumnRanges ranges{none, none, nz, 0};
  for (std::size_t i = 0; i < ranges.begin.size(); ++i) {
    int& begin = ranges.begin.values[i];
    int& end = ranges.end.values[i];
    begin = k == 0 ? 0 : std::max(0, layerOf(storeys.borders[k - 1].values[i]));
    end = k == storeys.borders.size()
              ? nz
              : std::min(nz, layerOf(storeys.borders[k].values[i]) + 1);
    if (begin >= end)
      continue;
    ranges.lowest = std::min(ranges.lowest, begin);
    ranges.highest = std::max(ranges.highest, end);
  }
  ranges.lowest = std::min(ranges.lowest, std::max(0, ranges.highest - 1));
  return ranges;
}

/** The layers that the ranges reach. */
GridShape
shapeOf(const GridShape& grid, const ColumnRanges& ranges, int factor)
{
  return {grid.nx,
          grid.ny,
          (ranges.highest + factor - 1) / factor - ranges.lowest / factor};
}

/** The voxels within the ranges; the others are not set.
 * \param[in] factor how many layers of the ranges one of the grid is */
VoxelBits
cut(const VoxelBits& grid, const ColumnRanges& ranges, int factor)
{
  const int first = ranges.lowest / factor;
  VoxelBits part;
  part.voxel_size = grid.voxel_size;
  part.origin = grid.origin + Eigen::Vector3d(0, 0, first * grid.voxel_size);
  part.reset(shapeOf(grid.shape, ranges, factor));
  for (int x = 0; x < grid.shape.nx; ++x)
    for (int y = 0; y < grid.shape.ny; ++y) {
      const int u = std::min(x * factor, ranges.begin.nx - 1);
      const int v = std::min(y * factor, ranges.begin.ny - 1);
      const int end = (ranges.end.at(u, v) + factor - 1) / factor;
      grid.column(x, y).forEachSet(ranges.begin.at(u, v) / factor, end, [&](int z) {
        part.set(x, y, z - first);
      });
    }
  return part;
}

} // namespace

StoreySpace
storeySpace(const VoxelBits& occupancy,
            const InteriorSpace& interior,
            const Storeys& storeys,
            std::size_t storey)
{
  const ColumnRanges ranges = columnRanges(occupancy, storeys, storey);
  StoreySpace space;
  space.occupancy = cut(occupancy, ranges, 1);
  space.first_layer = ranges.lowest;
  const double floor = (storeys.heights[storey].floor - space.occupancy.origin.z()) /
                       occupancy.voxel_size;
  const int layers = space.occupancy.shape.nz;
  space.range = {
      static_cast<int>(std::clamp(std::floor(floor), 0.0, std::max(0.0, layers - 1.0))),
      layers};
  space.interior.factor = interior.factor;
  space.interior.directions = interior.directions;
  space.interior.unseen.floor_seen = interior.unseen.floor_seen;
  space.interior.unseen.ceiling_seen = interior.unseen.ceiling_seen;
  space.interior.occupancy = cut(interior.occupancy, ranges, interior.factor);
  space.interior.inside = cut(interior.inside, ranges, interior.factor);
  return space;
}

} // namespace pcl::indoor
