/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/room_structure.h"

namespace pcl::indoor {

constexpr double normal_cosine = 0.9; ///< 26 degrees: noise of a voxel's normal
constexpr double sheet_cosine = 0.97; ///< 14 degrees: two regions of one plane

/** \brief Grow flat regions over touching voxels and put those of one plane together.
 * \return planes in the order of the size of their largest region; regions of fewer
 * than 50 voxels are left out
 */
std::vector<StructurePlane>
growPlanes(const SurfaceVoxels& voxels, double voxel_size, float flat_curvature);

} // namespace pcl::indoor
