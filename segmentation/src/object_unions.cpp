/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "object_unions.h"

#include <pcl/segmentation/convex_unions.h>
#include <pcl/segmentation/frame_unions.h>
#include <pcl/segmentation/rack_unions.h>
#include <pcl/segmentation/upright_unions.h>

namespace pcl {
namespace indoor {

void
joinSegments(const SurfaceVoxels& voxels,
             const std::vector<std::uint8_t>& in_plane,
             const std::vector<StructurePlane>& planes,
             const ObjectSegmentationOptions& options,
             std::vector<std::uint32_t>& segment_of_voxel)
{
  const Eigen::Matrix3f axes = axesOf(planes).cast<float>();
  const auto wall_axes = axesOfWalls(planes);
  for (const double max_size_ratio : {1.0, 0.5}) {
    if (options.partition == Partition::Graph) {
      ConvexUnionOptions unions;
      unions.air_per_contact = options.max_union_air;
      unions.voxel_size = options.voxel_size;
      unions.axes = axes;
      unions.max_size_ratio = max_size_ratio;
      joinConvexUnions(voxels, in_plane, unions, segment_of_voxel);
    }
    if (options.join_racks) {
      RackUnionOptions racks;
      racks.voxel_size = options.voxel_size;
      racks.axes = axes;
      racks.up = options.up;
      joinRacks(voxels, in_plane, racks, segment_of_voxel);
    }
    if (options.join_uprights) {
      UprightUnionOptions uprights;
      uprights.voxel_size = options.voxel_size;
      uprights.up = options.up;
      joinUprights(voxels, in_plane, uprights, segment_of_voxel);
    }
    if (options.join_frames) {
      FrameUnionOptions frames;
      frames.voxel_size = options.voxel_size;
      frames.up = options.up;
      for (const auto& along_wall : wall_axes) {
        frames.axes = along_wall.cast<float>();
        joinFrames(voxels, in_plane, frames, segment_of_voxel);
      }
    }
  }
}

} // namespace indoor
} // namespace pcl
