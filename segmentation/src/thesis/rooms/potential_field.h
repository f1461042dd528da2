/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/space/distance_map.h" // for kNoObstacle

namespace pcl::indoor {

/** \brief The anisotropic potential field (Sec. 3.2.2 of the thesis).
 * The squared distance of every voxel to the nearest occupied voxel that does not lie
 * below it, so that furniture on the floor hardly matters and walls and ceilings do.
 * Exact; time linear in the voxels.
 * \param[in] occupancy non-zero = occupied
 * \param[in] threads 0 = automatic; the result does not depend on it
 * \return between voxel centres, in voxels squared; 0 in occupied voxels, kNoObstacle
 * where all voxels at the same height and above are free
 */
VoxelMap<std::uint32_t>
potentialField(const VoxelMap<std::uint8_t>& occupancy, int threads = 0);

/** \brief The largest potential of each column (the map of Fig. 3.3 (D)).
 * \param[in] field as potentialField() gives it
 * \param[in] interior non-zero = interior free space; of the same shape
 * \return in voxels squared, over interior voxels with an obstacle; 0 in columns
 * without such
 * \throws pcl::BadArgumentException if the shapes differ
 */
PixelMap<float>
fieldMap(const VoxelMap<std::uint32_t>& field, const VoxelMap<std::uint8_t>& interior);

/** \brief The highest interior voxel of each column (Sec. 3.2.2).
 * \param[in] interior non-zero = interior free space
 * \return its z index, -1 in columns without interior
 */
PixelMap<int>
highestFreeVoxel(const VoxelMap<std::uint8_t>& interior);

} // namespace pcl::indoor
