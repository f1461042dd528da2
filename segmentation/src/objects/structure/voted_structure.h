/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/voxel_classes.h>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Where no plane decides, a surface is structure if more than this share of its
 * votes is for the building. */
constexpr double least_building_share = 0.4;

/** \brief Take the points that hardly anybody takes for the building out of their
 * planes: curtains, cabinets and doors in the planes of walls. A plane is evidence,
 * too: what lies in one needs fewer votes than a piece of surface that lies in none.
 * \param[in,out] plane_of_point from 1, 0 = none */
void
yieldToVotes(const VoxelClasses& votes, std::vector<std::uint32_t>& plane_of_point);

} // namespace pcl::indoor
