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

/** \brief What counts as a front that a shadow cuts. */
struct ShadowUnionOptions {
  double voxel_size = 0.03;                      ///< of the voxels, metres (> 0)
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ(); ///< against gravity, unit length
  double min_width = 0.15;  ///< of either piece of a front, metres (>= 0)
  double min_height = 0.2;  ///< metres (>= 0)
  double min_fill = 0.5;    ///< share of its outline that a piece fills, from 0 to 1
  double min_overlap = 0.8; ///< of the pieces' heights, in common over both (>= 0)
  double min_gap = 3;       ///< between the pieces, voxels (> 2)
  double max_gap = 0.5;     ///< metres (>= 0)
  double max_gap_share = 1; ///< of the narrower piece's width (>= 0)
  /** share of the gap's cells, a voxel wide, with something in the plane: the edges of
   * a shadow are ragged (>= 0) */
  double max_filled = 0.25;
  double max_seen = 0.05; ///< the same for what is seen behind the plane (>= 0)
  double min_hiding =
      0.5;          ///< cells with something before the plane, over the gap's (>= 0)
  double reach = 1; ///< how far before and behind the gap is looked, metres (>= 0)
};

/** \brief Join the pieces of a front that the shadow of something before it cuts, as a
 * chair's that of a cupboard. They are flat upright surfaces of at least 50 voxels, in
 * one plane, at the same height, with a gap between them that is narrower than they
 * are. Between two bodies one would see their sides, or, up to the reach, the wall
 * behind; in a shadow there is hardly anything in the plane and nothing behind it, but
 * something else before the gap, as far to the sides as the gap is wide. Pieces that
 * touch are left alone. No step of the thesis. The cost is linear in the number of
 * voxels, but for sorting, and once more for each gap that is looked through.
 * \param[in] voxels of the points, with oriented normals and curvatures
 * \param[in] left_out one per voxel: their segments are not joined (floor, walls), but
 * they are seen through gaps
 * \param[in,out] segment_of_point numbered from 0; pieces that are joined get the
 * number of one of them
 * \return how many pairs were joined
 * \throws pcl::BadArgumentException if sizes differ or an option is out of range
 */
std::size_t
joinAcrossShadows(const SurfaceVoxels& voxels,
                  const std::vector<std::uint8_t>& left_out,
                  const ShadowUnionOptions& options,
                  std::vector<std::uint32_t>& segment_of_point);

} // namespace indoor
} // namespace pcl
