/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/object_scene.h"

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Part segments at narrow empty gaps: bookcases side by side, the two halves of
 * a double desk, chairs in a row. No step of the thesis.
 *
 * The voxels on both sides of a gap touch, and the surfaces continue each other, so
 * voxels do not show the gap. Points do: an upright slice through the whole segment
 * holds hardly any points, though the slices beside it hold many. Up to a quarter of
 * their number counts as noise. A segment that reaches over more than 2^20 halves of a
 * voxel is left as it is. The cost is linear in the number of points times directions.
 * \param[in] left_out one per point: such points (floor, walls) keep their segment
 * \param[in,out] segment_of_point numbered from 0; new segments follow those that were
 * there
 */
void
partAtGaps(const ObjectScene& scene,
           const std::vector<std::uint8_t>& left_out,
           std::vector<std::uint32_t>& segment_of_point);

} // namespace pcl::indoor
