/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/storeys/storeys.h"

#include <pcl/indoor/voxel_bits.h>

#include <vector>

namespace pcl::indoor {

/** \brief Occupied voxels of a column with enough free space above and below: up to
 * something, or among walls. */
struct SlabGroup {
  int x;
  int y;
  int low;  // lowest voxel: the ceiling below
  int high; // highest voxel: the floor above

  double
  middle() const
  {
    return 0.5 * (low + high);
  }
};

/** \brief The slabs of about one height. */
struct SlabLevel {
  std::vector<SlabGroup> groups; // none if neither ceiling nor floor was seen
  double low = 0.0;              // median of the groups' lower ends, in voxels
  double high = 0.0;             // median of the groups' upper ends

  double
  middle() const
  {
    return 0.5 * (low + high);
  }
};

/** \brief The heights at which slabs divide a building, lowest first.
 *
 * A slab is level over metres, which neither stairs nor furniture are: the top or the
 * underside of most columns around it goes on at its height. The heights that most such
 * columns share are levels.
 * \param[in] unseen slabs that nobody saw, voxels: levels, too, where no other is near
 * REQUIRES: valid options.
 */
std::vector<SlabLevel>
findSlabLevels(const VoxelBits& occupancy,
               const StoreyOptions& options,
               int threads,
               const std::vector<double>& unseen);

} // namespace pcl::indoor
