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
 * as are those of the frames of doors and windows. */
bool
isThinAlong(const StructurePlane& plane,
            const std::vector<Eigen::Vector3f>& points,
            const std::vector<std::uint32_t>& members);

/** \brief Leave the frames of doors and windows out: the segments that are thin along a
 * wall and go through it, with a twentieth of their points more than a voxel behind it.
 * A wall cabinet is as thin, but before its wall.
 * \param[in] planes whose normals point into the room
 * \param[in] up against gravity, unit length
 * \param[in] segment_of_point numbered from 0
 * \param[in,out] left_out one per point: such points count to no segment
 */
void
leaveOutWallFrames(const std::vector<Eigen::Vector3f>& points,
                   const std::vector<StructurePlane>& planes,
                   const Eigen::Vector3f& up,
                   double voxel_size,
                   const std::vector<std::uint32_t>& segment_of_point,
                   std::vector<std::uint8_t>& left_out);

} // namespace indoor
} // namespace pcl
