/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/voxel_classes.h>
#include <pcl/segmentation/objects/piece_graph.h>
#include <pcl/segmentation/objects/room_structure.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief Take the points that hardly anybody takes for the building out of their
 * planes: curtains, cabinets and doors in the planes of walls.
 * \param[in,out] plane_of_point from 1, 0 = none */
void
yieldToVotes(const VoxelClasses& votes, std::vector<std::uint32_t>& plane_of_point);

/** \brief What the building's pieces are by the votes of their voxels: patches of walls
 * and floors that are part of no plane. All None if nobody voted. */
std::vector<StructureKind>
votedStructure(const PieceGraph& graph);

} // namespace indoor
} // namespace pcl
