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

/** \brief What counts as an upright, and what as a level segment that it belongs to. */
struct UprightUnionOptions {
  double voxel_size = 0.03;                      ///< of the voxels, metres (> 0)
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ(); ///< against gravity, unit length
  double max_thickness = 0.2;                    ///< of an upright, metres (> 0)
  double min_height = 0.1;                       ///< of an upright, metres (>= 0)
  /** share of an upright's columns that touch the other segment */
  double min_cover = 0.4;
  /** share of the other segment that is level: of all of it, or, for what is carried,
   * of what is at the height of the upright's upper edge */
  double min_level = 0.5;
  double max_above = 0.4; ///< how far what is carried rises above that edge, metres
  /** for backs: the width that both have in common, over that of both together */
  double min_overlap = 0.8;
};

/** \brief Join thin uprights to the level segments that they carry or end. A scan sees
 * the inner side of the end board of a desk, concave to its underside, and the back of
 * a chair or the head of a bed, concave to what one sits or lies on. But an upright,
 * thin in one level direction, that ends with its upper edge in a level segment that
 * rises little above it is a leg or an end board of that; and one that touches a level
 * segment of its own width is a back or a head board. No step of the thesis. The cost
 * is n log n in the number of voxels, and linear in those of each segment that an
 * upright may end.
 * \param[in] voxels their normals tell what is level
 * \param[in] left_out one flag per voxel; segments of flagged voxels are not joined
 * \param[in,out] segment_of_voxel numbered from 0
 * \throws pcl::BadArgumentException if sizes differ or an option is out of range
 */
void
joinUprights(const SurfaceVoxels& voxels,
             const std::vector<std::uint8_t>& left_out,
             const UprightUnionOptions& options,
             std::vector<std::uint32_t>& segment_of_voxel);

} // namespace indoor
} // namespace pcl
