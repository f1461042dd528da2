/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/structure/structure_islands.h"

#include <pcl/indoor/flood_fill.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::indoor {

void
returnIslands(std::size_t patch_size, std::size_t min_size, ObjectScene& scene)
{
  const auto& voxels = scene.voxels;
  auto& plane_of_voxel = scene.plane_of_voxel;
  std::vector<std::uint8_t> seen(voxels.size(), 0);
  std::vector<std::uint32_t> island;
  const auto lies_in = [&](const StructurePlane& plane) {
    const double reach =
        (island.size() < patch_size ? near_surface_voxels : 1) * scene.voxel_size;
    return std::all_of(island.begin(), island.end(), [&](std::uint32_t v) {
      return std::abs(plane.normal.dot(voxels.centroids[v].cast<double>()) -
                      plane.offset) <= reach;
    });
  };
  for (std::uint32_t first = 0; first < voxels.size(); ++first) {
    if (seen[first] || plane_of_voxel[first] != 0)
      continue;
    seen[first] = 1;
    island.assign(1, first);
    floodFill(island, voxels.neighbors, [&](auto other, auto) {
      return plane_of_voxel[other] == 0 && !std::exchange(seen[other], 1);
    });
    if (island.size() >= std::max(min_size, patch_size))
      continue;
    const auto plane = std::find_if(scene.planes.begin(), scene.planes.end(), lies_in);
    if (plane != scene.planes.end())
      for (const auto v : island)
        plane_of_voxel[v] =
            static_cast<std::uint32_t>(plane - scene.planes.begin() + 1);
  }
}

} // namespace pcl::indoor
