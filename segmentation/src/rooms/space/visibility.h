/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>

#include <Eigen/Core>

#include <cstdint>

namespace pcl::indoor {

/** \brief Whether no occupied voxel lies between two voxels (Sec. 3.2.2 of the thesis).
 * Looks at every voxel whose inside the segment between the two centres crosses, in
 * integer arithmetic, so that a sees b exactly if b sees a. The end voxels themselves
 * never block.
 * REQUIRES: both lie in the grid.
 */
bool
lineOfSight(const VoxelMap<std::uint8_t>& occupancy,
            const Eigen::Vector3i& a,
            const Eigen::Vector3i& b);

} // namespace pcl::indoor
