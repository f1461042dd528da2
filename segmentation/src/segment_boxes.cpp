/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "segment_boxes.h"

#include "interval.h"
#include "segment_members.h"

#include <pcl/exceptions.h>

#include <algorithm>

namespace pcl {
namespace indoor {

void
requireOnePerVoxel(const SurfaceVoxels& voxels,
                   const std::vector<std::uint8_t>& left_out,
                   const std::vector<std::uint32_t>& segment_of_voxel)
{
  if (left_out.size() != voxels.size() || segment_of_voxel.size() != voxels.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        voxels.size()
                            << " voxels have " << left_out.size() << " flags and "
                            << segment_of_voxel.size() << " segments.");
}

std::vector<SegmentBox>
segmentBoxes(const SurfaceVoxels& voxels,
             const std::vector<std::uint8_t>& left_out,
             const std::vector<std::uint32_t>& segment_of_voxel,
             const Eigen::Matrix3f& axes,
             double voxel_size)
{
  const auto members = membersOfSegments(left_out, segment_of_voxel);
  std::vector<SegmentBox> boxes(members.size());
  std::vector<double> heights;
  for (std::size_t s = 0; s < members.size(); ++s) {
    boxes[s].size = members[s].size();
    for (int axis = 0; axis < 3 && !members[s].empty(); ++axis) {
      heights.clear();
      for (const auto v : members[s])
        heights.push_back(axes.col(axis).dot(voxels.centroids[v]));
      const auto range = trimmedRange(heights).widened(voxel_size / 2);
      boxes[s].low[axis] = range.low;
      boxes[s].high[axis] = range.high;
    }
  }
  return boxes;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>>
touchingSegments(const SurfaceVoxels& voxels,
                 const std::vector<std::uint8_t>& left_out,
                 const std::vector<std::uint32_t>& segment_of_voxel)
{
  std::vector<std::pair<std::uint32_t, std::uint32_t>> touching;
  for (std::size_t v = 0; v < voxels.size(); ++v)
    for (auto j = voxels.neighbors.offsets[v]; j < voxels.neighbors.offsets[v + 1];
         ++j) {
      const auto other = voxels.neighbors.targets[j];
      if (!left_out[v] && !left_out[other] &&
          segment_of_voxel[v] < segment_of_voxel[other])
        touching.emplace_back(segment_of_voxel[v], segment_of_voxel[other]);
    }
  std::sort(touching.begin(), touching.end());
  touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
  return touching;
}

} // namespace indoor
} // namespace pcl
