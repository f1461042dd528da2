/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/ceiling_slab.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl {
namespace indoor {
namespace {

PixelMap<int>
highestOccupied(const VoxelGrid<std::uint8_t>& occupancy, const VerticalRange& storey)
{
  const GridShape& shape = occupancy.shape;
  PixelMap<int> top{shape.nx, shape.ny, {}};
  top.values.assign(top.size(), -1);
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y) {
      const std::uint8_t* column = &occupancy.values[shape.index(x, y, 0)];
      int z = storey.end - 1;
      while (z >= storey.begin && !column[z])
        --z;
      top.at(x, y) = z >= storey.begin ? z : -1;
    }
  return top;
}

/** The maximum over a window of 2 * radius + 1 values with a stride, by a sliding block
 * maximum (van Herk): three comparisons per value, whatever the radius. */
void
slidingMaximum(int* values, int count, std::size_t stride, int radius)
{
  const int block = 2 * radius + 1;
  const int padded = (count + 2 * radius + block - 1) / block * block;
  std::vector<int> forward(padded, -1), backward(padded, -1);
  const auto value = [&](int i) {
    const int k = i - radius;
    return k >= 0 && k < count ? values[k * stride] : -1;
  };
  for (int i = 0; i < padded; ++i)
    forward[i] = i % block ? std::max(forward[i - 1], value(i)) : value(i);
  for (int i = padded - 1; i >= 0; --i)
    backward[i] = (i + 1) % block
                      ? std::max(i + 1 < padded ? backward[i + 1] : -1, value(i))
                      : value(i);
  for (int i = 0; i < count; ++i)
    values[i * stride] = std::max(backward[i], forward[i + block - 1]);
}

} // namespace

PixelMap<int>
ceilingLayers(const VoxelGrid<std::uint8_t>& occupancy,
              const VerticalRange& storey,
              const CeilingSlabOptions& options)
{
  const PixelMap<int> top = highestOccupied(occupancy, storey);
  PixelMap<int> ceiling = top;
  const int radius =
      static_cast<int>(std::lround(0.5 * options.window / occupancy.voxel_size));
  for (int x = 0; x < top.nx; ++x)
    slidingMaximum(&ceiling.values[top.index(x, 0)], top.ny, 1, radius);
  for (int y = 0; y < top.ny; ++y)
    slidingMaximum(&ceiling.values[top.index(0, y)], top.nx, top.ny, radius);

  const int step = static_cast<int>(std::lround(options.step / occupancy.voxel_size));
  for (std::size_t i = 0; i < top.size(); ++i)
    if (top.values[i] >= 0 && top.values[i] >= ceiling.values[i] - step)
      ceiling.values[i] = top.values[i];
  return ceiling;
}

PixelMap<std::uint8_t>
blockedBelowCeiling(const VoxelGrid<std::uint8_t>& occupancy,
                    const VerticalRange& storey,
                    const PixelMap<int>& ceiling,
                    const CeilingSlabOptions& options)
{
  const GridShape& shape = occupancy.shape;
  const int gap =
      static_cast<int>(std::lround(options.gap / occupancy.voxel_size + 0.5));
  const int depth =
      std::max(1, static_cast<int>(std::lround(options.depth / occupancy.voxel_size)));
  PixelMap<std::uint8_t> blocked{shape.nx, shape.ny, {}};
  blocked.values.assign(blocked.size(), 0);
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y) {
      const int top = ceiling.at(x, y) - gap;
      const std::uint8_t* column = &occupancy.values[shape.index(x, y, 0)];
      for (int z = std::max(storey.begin, top - depth + 1); z <= top; ++z)
        if (column[z]) {
          blocked.at(x, y) = 1;
          break;
        }
    }
  return blocked;
}

} // namespace indoor
} // namespace pcl
