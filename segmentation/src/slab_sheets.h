/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/segmentation/storeys.h>
#include <pcl/segmentation/voxel_grid.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief Occupied voxels of a column with enough free space above and below. */
struct SlabGroup {
  int x;
  int y;
  int low;  // lowest voxel
  int high; // highest voxel
};

/** \brief A connected slab. */
struct SlabSheet {
  std::vector<SlabGroup> groups;
  double low;  // median of the groups' lower ends: the ceiling below, in voxels
  double high; // median of the groups' upper ends: the floor above

  double
  middle() const
  {
    return 0.5 * (low + high);
  }
};

/** \brief The slabs of a grid, in the order of their first column.
 * REQUIRES: valid options, as many values as voxels.
 */
std::vector<SlabSheet>
findSlabSheets(const VoxelGrid<std::uint8_t>& occupancy, const StoreyOptions& options);

} // namespace indoor
} // namespace pcl
