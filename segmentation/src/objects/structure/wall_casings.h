/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/object_scene.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

constexpr double casing_depth = 0.2; ///< of a casing on either side of its wall, metres

/** \brief Tell whether at least 95 % of some points lie within casing_depth of a plane,
 * as those of casings of doors and windows do; true for no points. */
bool
isThinAlong(const StructurePlane& plane,
            const std::vector<Eigen::Vector3f>& points,
            const std::vector<std::uint32_t>& members);

/** \brief Flag the points that stay in one segment: those of the structure, and those
 * of the casings of doors and windows.
 *
 * A casing is a segment that meets the extent of an upright plane, is thin along it
 * (see isThinAlong()), with at least 5 % of its points more than a voxel behind the
 * wall. A wall cabinet may be as thin, but has no points behind the wall.
 *
 * \param[in] segment_of_point numbered from 0
 * \return one flag per point
 */
std::vector<std::uint8_t>
flagStructureAndCasings(const ObjectScene& scene,
                        const std::vector<std::uint32_t>& segment_of_point);

} // namespace pcl::indoor
