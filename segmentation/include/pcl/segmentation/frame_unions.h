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

/** \brief What counts as a piece of a frame. */
struct FrameUnionOptions {
  double voxel_size = 0.03; ///< of the voxels, metres (> 0)
  /** three orthogonal directions, one per column, that frames follow */
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ(); ///< against gravity, unit length
  double max_thickness = 0.25; ///< of a piece, and width of a bar, metres (> 0)
  double min_length = 0.3;     ///< of a piece, metres (>= 0)
  double min_elongation = 2;   ///< length over width of a bar (>= 1)
  double max_fill = 0.5;    ///< share of its outline that a piece that is no bar fills
  double min_overlap = 0.5; ///< of the thickness of two pieces over that of both
};

/** \brief Join the touching pieces of upright frames: the jambs and the head of a door,
 * the bars of a window. They meet in concave corners, and there is much air between
 * them. A piece is thin across one of the level axes and, along the others, a narrow
 * bar or of an open shape, as an L; two that touch and lie in one upright layer are one
 * frame. No step of the thesis. The cost is linear in the number of voxels.
 * \param[in] left_out one flag per voxel; segments of flagged voxels are not joined
 * \param[in,out] segment_of_voxel numbered from 0
 * \throws pcl::BadArgumentException if sizes differ or an option is out of range
 */
void
joinFrames(const SurfaceVoxels& voxels,
           const std::vector<std::uint8_t>& left_out,
           const FrameUnionOptions& options,
           std::vector<std::uint32_t>& segment_of_voxel);

} // namespace indoor
} // namespace pcl
