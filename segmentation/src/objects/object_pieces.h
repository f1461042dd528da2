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

/** Number the segments from 0 in the order of their first points. */
void
numberSegments(ObjectSegmentation& result);

/** Part what points tell apart, but voxels do not: flat things from what they lie on,
 * and both sides of narrow gaps. */
void
cutPieces(const std::vector<Eigen::Vector3f>& points,
          const std::vector<std::uint32_t>& piece_of_voxel,
          const ObjectSegmentationOptions& options,
          ObjectSegmentation& result);

/** Take the segments for pieces, and join those that are probably one thing. */
void
joinPiecesOfRoom(const std::vector<StructurePlane>& planes,
                 const ObjectSegmentationOptions& options,
                 ObjectSegmentation& result);

/** Part bodies at gaps and at the sides with which they stand against each other. */
void
cutBodies(const std::vector<Eigen::Vector3f>& points,
          const std::vector<StructurePlane>& planes,
          const ObjectSegmentationOptions& options,
          ObjectSegmentation& result);

} // namespace indoor
} // namespace pcl
