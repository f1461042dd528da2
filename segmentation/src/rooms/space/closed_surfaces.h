/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_grid.h>

#include <cstdint>

namespace pcl {
namespace indoor {

/** \brief The voxel size at which the points' surfaces have few holes.
 *
 * A closed surface needs four times as many voxels of half the size; sparse points
 * fill fewer. At the size returned there are at least three per voxel twice as large.
 * \param[in] grid 1 = occupied
 * \return a multiple of 1 cm, or the grid's own size where that is enough; at most
 * \a largest
 */
double
closedVoxelSize(const VoxelGrid<std::uint8_t>& grid, double largest);

} // namespace indoor
} // namespace pcl
