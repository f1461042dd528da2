/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>

#include <cstdint>

namespace pcl::indoor {

/** \brief Free what hangs in a column, such as lamps (Sec. 3.2.1.1).
 *
 * Along every vertical column the pattern
 * "occupied"-"free"-"occupied"-"free"-"occupied" is detected, and its central occupied
 * voxel is freed. The other parts of the pattern are runs of one or more voxels; the
 * thesis speaks of isolated voxels in the middle. Thus the lowest and the highest run
 * of a column always stay, and so does a longer run. All runs of a column are judged in
 * the column as given: freeing one does not change the pattern of the next.
 *
 * Linear in the number of voxels.
 *
 * \param[in,out] grid occupied voxels are not 0; freed ones become 0
 * \param[in] threads number of threads (>= 0; 0 = automatic)
 * \throws pcl::BadArgumentException if threads is negative, or if the number of values
 * does not fit the shape
 */
void
cleanUpVertically(VoxelMap<std::uint8_t>& grid, int threads = 0);

} // namespace pcl::indoor
