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

struct ConvexUnionOptions {
  /** segments are joined if the volume of their union is not above this multiple of the
   * sum of theirs (>= 0; 0 joins none) */
  double max_growth = 1.0;
  double voxel_size = 0.03; ///< of the voxels, metres (> 0)
  /** three orthogonal directions, one per column, that volumes are most exact for */
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
};

/** \brief Join touching segments whose union fills its convex hull as well as they fill
 * theirs: the compartments of a bookcase, a mattress in its bed. A cup on a table or
 * the back of a chair is not joined, because the hull of both holds much air. Hulls are
 * polytopes with 50 fixed directions of faces. Pairs are joined in ascending order of
 * the ratio of volumes, ties in the order of segments. The cost is linear in the number
 * of voxels, and n log n in the number of segments, at about 0.1 ms for each pair that
 * touches. \param[in] left_out one flag per voxel; segments of flagged voxels are not
 * joined \param[in,out] segment_of_voxel any numbers below the number of voxels +
 * segments \throws pcl::BadArgumentException if sizes differ or an option is out of
 * range
 */
void
joinConvexUnions(const SurfaceVoxels& voxels,
                 const std::vector<std::uint8_t>& left_out,
                 const ConvexUnionOptions& options,
                 std::vector<std::uint32_t>& segment_of_voxel);

} // namespace indoor
} // namespace pcl
