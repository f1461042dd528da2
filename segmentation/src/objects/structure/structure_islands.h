/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/object_scene.h"

#include <cstddef>

namespace pcl::indoor {

/** \brief Give small flat groups of voxels in front of a plane to the plane: they are
 * noise, or a wall that was registered twice.
 * \param[in] patch_size groups of fewer touching voxels go to a plane if all of them
 * are within two voxels of it
 * \param[in] min_size groups of fewer voxels do, if all are within one voxel
 */
void
returnIslands(std::size_t patch_size, std::size_t min_size, ObjectScene& scene);

} // namespace pcl::indoor
