/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/objects/object_scene.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief Part segments at the seams between closed bodies that stand against each
 * other without a gap, as the cabinets of a kitchen. Their fronts and tops go on and
 * bend nothing, but a scan sees some of the sides that face each other: an upright
 * sheet of points where there should be none, in the inside of the segment. A cell of
 * the section is inside if neither side has points there, but both have some above it,
 * or both below, and both before it, or both behind. The compartments of a shelf are
 * open, and the normals around them point into them.
 *
 * The cut is amid the sheet; if it goes on outside of what one side encloses, as the
 * side of a refrigerator above a worktop, it belongs to the other. No step of the
 * thesis. A segment that reaches over more than 4096 voxels is left as it is. The cost
 * is linear in the number of points times directions.
 * \param[in] left_out one per point: such points (floor, walls) keep their segment
 * \param[in,out] segment_of_point numbered from 0; new segments follow those that were
 * there
 * \throws pcl::BadArgumentException if sizes differ
 */
void
partAtSeams(const ObjectScene& scene,
            const std::vector<std::uint8_t>& left_out,
            std::vector<std::uint32_t>& segment_of_point);

} // namespace indoor
} // namespace pcl
