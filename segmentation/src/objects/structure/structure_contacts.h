/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/object_scene.h"

#include <pcl/indoor/voxel_classes.h>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Give the points at which objects touch floor and walls back to the objects.
 * The sides of a cupboard reach down to the floor and back to the wall. Their points
 * near these planes were taken for the planes. Each such point goes to the nearest
 * surface, unless it is part of the building by its votes (least_building_share):
 * among the objects' voxels around it, the one whose tangent plane is nearest, if that
 * is nearer than the point's own plane. Centroids, normals and curvatures of voxels
 * stay as they are; the cost is linear in the number of points.
 * \param[in] surroundings voxels of the same points that ignore the planes; may be
 * larger
 * \param[in] votes of the points, or of none
 * \param[in,out] scene whose voxels hold points of one plane only; only their cells
 * change, and voxels of planes may be left without points
 * \return how many points changed sides
 */
std::size_t
yieldContacts(const SurfaceVoxels& surroundings,
              const VoxelClasses& votes,
              ObjectScene& scene);

} // namespace pcl::indoor
