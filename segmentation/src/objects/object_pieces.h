/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/object_segmentation.h>
#include <pcl/segmentation/objects/room_structure.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** Part what points tell apart, but voxels do not: flat things from what they lie on,
 * and both sides of narrow gaps. Sets the segments of the points. */
void
cutPieces(const std::vector<std::uint32_t>& piece_of_voxel, ObjectSegmentation& result);

/** Take the segments for pieces, and join those that are probably one thing. */
void
joinPiecesOfRoom(const ObjectSegmentationOptions& options, ObjectSegmentation& result);

/** Part bodies at gaps and at the sides with which they stand against each other. */
void
cutBodies(ObjectSegmentation& result);

} // namespace indoor
} // namespace pcl
