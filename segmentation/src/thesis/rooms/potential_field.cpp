/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "thesis/rooms/potential_field.h"

#include <pcl/exceptions.h>
#include <pcl/indoor/threads.h>

#include <algorithm>

namespace pcl::indoor {

VoxelMap<std::uint32_t>
potentialField(const VoxelMap<std::uint8_t>& occupancy, int threads)
{
  VoxelMap<std::uint32_t> field;
  field.shape = occupancy.shape;
  field.origin = occupancy.origin;
  field.voxel_size = occupancy.voxel_size;
  field.values.resize(occupancy.shape.size());
  const auto nx = static_cast<std::size_t>(field.shape.nx);
  const auto ny = static_cast<std::size_t>(field.shape.ny);
  const auto nz = static_cast<std::size_t>(field.shape.nz);
  const int count = usefulThreads(threads, nx * ny, 2000);
  // Upwards only: the half-space of Sec. 3.2.2 limits z alone, so x and y stay
  // separable.
  const auto columns = static_cast<std::ptrdiff_t>(nx * ny);
#pragma omp parallel for num_threads(count) schedule(static)
  for (std::ptrdiff_t column = 0; column < columns; ++column) {
    const std::size_t start = static_cast<std::size_t>(column) * nz;
    std::uint32_t above = 0;
    bool covered = false;
    for (std::size_t z = nz; z-- > 0;) {
      ++above;
      if (occupancy.values[start + z]) {
        above = 0;
        covered = true;
      }
      field.values[start + z] = covered ? above * above : kNoObstacle;
    }
  }
  transformAlong(field.values, nx, ny * nz, nz, nz, field.shape.ny, count);
  transformAlong(field.values, 1, 0, ny * nz, ny * nz, field.shape.nx, count);
  return field;
}

PixelMap<float>
fieldMap(const VoxelMap<std::uint32_t>& field, const VoxelMap<std::uint8_t>& interior)
{
  if (field.shape != interior.shape)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The field and the interior have different shapes.");
  const GridShape& shape = field.shape;
  auto map = PixelMap<float>::filled(shape.nx, shape.ny, 0.0f);
  const auto nz = static_cast<std::size_t>(shape.nz);
  for (std::size_t pixel = 0; pixel < map.size(); ++pixel) {
    std::uint32_t highest = 0;
    for (std::size_t i = pixel * nz; i < (pixel + 1) * nz; ++i)
      if (interior.values[i] && field.values[i] != kNoObstacle)
        highest = std::max(highest, field.values[i]);
    map.values[pixel] = static_cast<float>(highest);
  }
  return map;
}

PixelMap<int>
highestFreeVoxel(const VoxelMap<std::uint8_t>& interior)
{
  const GridShape& shape = interior.shape;
  auto map = PixelMap<int>::filled(shape.nx, shape.ny, -1);
  const auto nz = static_cast<std::size_t>(shape.nz);
  for (std::size_t pixel = 0; pixel < map.size(); ++pixel)
    for (std::size_t z = nz; z-- > 0;)
      if (interior.values[pixel * nz + z]) {
        map.values[pixel] = static_cast<int>(z);
        break;
      }
  return map;
}

} // namespace pcl::indoor
