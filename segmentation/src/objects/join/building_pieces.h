/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/join/piece_graph.h"

#include <pcl/segmentation/object_segmentation.h>

#include <vector>

namespace pcl::indoor {

/** \brief What pieces are that are part of the building by the votes of their voxels:
 * patches of walls and floors that lie in no plane. All None if nobody voted. */
std::vector<StructureKind>
buildingPieces(const PieceGraph& graph);

/** \brief Take out the contacts of the building's pieces: they are joined to nothing.
 * \param[in] kinds as buildingPieces() gives them */
void
leaveAlone(const std::vector<StructureKind>& kinds, PieceGraph& graph);

} // namespace pcl::indoor
