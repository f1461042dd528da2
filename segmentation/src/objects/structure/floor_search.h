/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/room_structure.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

constexpr double other_layer = 0.3; ///< metres behind floors and ceilings, as of a roof
constexpr double min_free = 0.7;    ///< share of a plane with nothing behind it

/** \brief Get the area of a plane's voxels, m^2. */
double
areaOfPlane(const StructurePlane& plane, double voxel_size);

/** \brief Get the share of a plane with nothing farther behind it than a margin.
 * \param[in] margin metres; near_surface_voxels at least
 */
double
freeShareOfPlane(const SurfaceVoxels& voxels,
                 const StructurePlane& plane,
                 double margin,
                 double voxel_size);

/** \brief Find the floors among planes: the lowest level ones, and those with which
 * these go on, as floors do that drift or slope. What lies below a plane is looked for
 * only where that decides: it costs a look at all voxels.
 * \return whether each plane is a floor
 */
std::vector<std::uint8_t>
floorsAmong(const std::vector<StructurePlane>& planes,
            const SurfaceVoxels& voxels,
            double voxel_size,
            const Eigen::Vector3f& up);

} // namespace pcl::indoor
