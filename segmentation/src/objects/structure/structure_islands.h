/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/objects/object_scene.h>

#include <cstddef>

namespace pcl {
namespace indoor {

/** \brief Give small flat remains in front of a plane back to it: noise, and the second
 * of two registrations of a wall.
 * \param[in] patch_size groups of touching voxels of fewer than this are given to a
 * plane if none of them is farther than two voxels from it
 * \param[in] min_size so are those of fewer than this, if none is farther than one
 * voxel
 */
void
returnIslands(std::size_t patch_size, std::size_t min_size, ObjectScene& scene);

} // namespace indoor
} // namespace pcl
