/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/object_scene.h"

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Part segments at the seams between closed bodies that stand against each
 * other without a gap, such as the cabinets of a kitchen. No step of the thesis.
 *
 * Fronts and tops of such bodies form one surface. But a scan sees some points of the
 * two sides that face each other: an upright sheet of points in the inside of the
 * segment, where there should be none.
 *
 * The segment is cut by an upright plane into two sides and a section, whose cells are
 * one voxel wide. A cell is inside if neither side has points in it, both sides have
 * points above it (or both below), and both have points before it (or both behind). A
 * sheet that fills enough of the inside is a seam. Compartments of a shelf are no
 * inside: they are open, so the normals around them point into them.
 *
 * The cut goes through the middle of the sheet. Segments that reach over more than 4096
 * voxels are left as they are. The cost is linear in the number of points times
 * directions.
 * \param[in] left_out one per point: such points (floor, walls) keep their segment
 * \param[in,out] segment_of_point numbered from 0; new segments follow those that were
 * there
 */
void
partAtSeams(const ObjectScene& scene,
            const std::vector<std::uint8_t>& left_out,
            std::vector<std::uint32_t>& segment_of_point);

} // namespace pcl::indoor
