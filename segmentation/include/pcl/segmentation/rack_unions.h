/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/surface_voxels.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief What counts as a rack, or a bookcase without a back. */
struct RackUnionOptions {
  double voxel_size = 0.03; ///< of the voxels, metres (> 0)
  /** three orthogonal directions, one per column, that racks follow, one of them up */
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ(); ///< against gravity, unit length
  double max_thickness = 0.25; ///< of a board, level or upright, metres (> 0)
  double min_width = 0.15;     ///< of its pieces, from above, metres (>= 0)
  double min_length = 0.3;     ///< of its pieces, from above, metres (>= 0)
  /** the area, seen from above, that two pieces share, over that of both together */
  double min_overlap = 0.7;
};

/** \brief Join the pieces of racks. Level boards and compartments lie above each other
 * with the same outline, held by the same uprights, with much air between them. Two
 * segments are of one rack if they have nearly the same outline from above, and touch
 * each other, or one is a level board and both touch the same third one. What touches a
 * rack and lies within its box, by two voxels, is of it, too; so is an upright board
 * beside its ends, however high. No step of the thesis. The cost is linear in the
 * number of voxels, and in the pairs of a board and another neighbour of the same one.
 * \param[in] left_out one flag per voxel; segments of flagged voxels are not joined
 * \param[in,out] segment_of_voxel numbered from 0
 * \throws pcl::BadArgumentException if sizes differ or an option is out of range
 */
void
joinRacks(const SurfaceVoxels& voxels,
          const std::vector<std::uint8_t>& left_out,
          const RackUnionOptions& options,
          std::vector<std::uint32_t>& segment_of_voxel);

} // namespace indoor
} // namespace pcl
