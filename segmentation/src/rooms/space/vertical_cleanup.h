/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>

#include <cstddef>
#include <cstdint>

namespace pcl::indoor {

/** \brief Free what hangs in a column, such as lamps (Sec. 3.2.1.1).
 *
 * Along every vertical column the pattern
 * "occupied"-"free"-"occupied"-"free"-"occupied" is detected, and its central occupied
 * voxels are freed. Each part of the pattern is a run of one or more voxels; the
 * central run may be up to max_run voxels long (the thesis speaks of isolated voxels:
 * 1). Thus the lowest and the highest run of a column always stay, and so does a run
 * that is longer than max_run. All runs of a column are judged in the column as given:
 * freeing one does not change the pattern of the next.
 *
 * Linear in the number of voxels.
 *
 * \param[in,out] grid occupied voxels are not 0; freed ones become 0
 * \param[in] max_run longest run of occupied voxels to free (>= 0; 0 frees nothing)
 * \param[in] threads number of threads (>= 0; 0 = automatic)
 * \return the number of voxels that were freed
 * \throws pcl::BadArgumentException if max_run or threads is negative, or if the number
 * of values does not fit the shape
 */
std::size_t
cleanUpVertically(VoxelMap<std::uint8_t>& grid, int max_run = 1, int threads = 0);

} // namespace pcl::indoor
