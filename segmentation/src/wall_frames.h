/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/room_structure.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief Tell whether all but a twentieth of some points are within 0.2 m of a plane,
 * as are those of the frames of doors and windows; none are. */
bool
isThinAlong(const StructurePlane& plane,
            const std::vector<Eigen::Vector3f>& points,
            const std::vector<std::uint32_t>& members);

/** \brief Flag the points that stay in one segment: those of the structure, and those
 * of the frames of doors and windows. A frame is a segment that is thin along a wall,
 * not beside it, and has a twentieth of its points more than a voxel behind it; a wall
 * cabinet is as thin, but before its wall.
 * \param[in] voxels of the points
 * \param[in] planes whose normals point into the room
 * \param[in] plane_of_voxel the number of its plane, from 1; 0 for objects
 * \param[in] up against gravity, unit length
 * \param[in] segment_of_point numbered from 0
 * \return one flag per point
 */
std::vector<std::uint8_t>
flagStructureAndFrames(const std::vector<Eigen::Vector3f>& points,
                       const SurfaceVoxels& voxels,
                       const std::vector<StructurePlane>& planes,
                       const std::vector<std::uint32_t>& plane_of_voxel,
                       double voxel_size,
                       const Eigen::Vector3f& up,
                       const std::vector<std::uint32_t>& segment_of_point);

} // namespace indoor
} // namespace pcl
