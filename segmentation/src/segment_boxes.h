/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/surface_voxels.h>

#include <Eigen/Core>

#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace indoor {

/** \throws pcl::BadArgumentException unless there is one flag and one segment per voxel
 */
void
requireOnePerVoxel(const SurfaceVoxels& voxels,
                   const std::vector<std::uint8_t>& left_out,
                   const std::vector<std::uint32_t>& segment_of_voxel);

/** Give the voxels of segments that were joined the same number.
 * \param[in] number_of the number for that of a segment; flagged voxels keep theirs */
template <typename NumberOf>
void
renumberSegments(const std::vector<std::uint8_t>& left_out,
                 NumberOf number_of,
                 std::vector<std::uint32_t>& segment_of_voxel)
{
  for (std::size_t v = 0; v < segment_of_voxel.size(); ++v)
    if (!left_out[v])
      segment_of_voxel[v] = number_of(segment_of_voxel[v]);
}

/** The box of a segment along three axes, without its outermost voxels. */
struct SegmentBox {
  std::size_t size = 0; ///< voxels; 0 = there is no such segment
  Eigen::Array3d low = Eigen::Array3d::Zero(), high = Eigen::Array3d::Zero();

  Eigen::Array3d
  extent() const
  {
    return high - low;
  }
};

/** One per number of a segment; flagged voxels do not count. REQUIRES: voxels. */
std::vector<SegmentBox>
segmentBoxes(const SurfaceVoxels& voxels,
             const std::vector<std::uint8_t>& left_out,
             const std::vector<std::uint32_t>& segment_of_voxel,
             const Eigen::Matrix3f& axes,
             double voxel_size);

/** The pairs of segments that touch, smaller number first, ascending. */
std::vector<std::pair<std::uint32_t, std::uint32_t>>
touchingSegments(const SurfaceVoxels& voxels,
                 const std::vector<std::uint8_t>& left_out,
                 const std::vector<std::uint32_t>& segment_of_voxel);

} // namespace indoor
} // namespace pcl
