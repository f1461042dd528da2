/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_bits.h>

#include <cstdint>

namespace pcl::indoor {

/** \brief Whether the surfaces of a grid have holes: one of twenty occupied voxels has
 * fewer than five of the 26 around it occupied. With voxels of 10 cm, whole scans of
 * rooms have up to 4 %, maps of robots and hand-held lidars 4 to 65 %: where rings are
 * apart, and where a surface was seen from far off. */
bool
hasHoles(const VoxelBits& grid);

/** \brief The smallest voxel size at which the points' surfaces have few holes.
 *
 * Where voxels twice as large hold a closed surface, four voxels of half the edge are
 * occupied in each; with sparse points fewer are. At the size returned it is at least
 * three on average.
 * What lies far from anything upright, such as the ground around a building, does not
 * count.
 * \param[in] all set = occupied
 * \return a multiple of 1 cm, or the grid's own size where that is enough; at most
 * \a largest
 */
double
closedVoxelSize(const VoxelBits& all, double largest);

} // namespace pcl::indoor
