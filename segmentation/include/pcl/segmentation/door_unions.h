/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/room_structure.h>
#include <pcl/segmentation/surface_voxels.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief What counts as the open leaf of a door or window. */
struct DoorUnionOptions {
  double voxel_size = 0.03;                      ///< of the voxels, metres (> 0)
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ(); ///< against gravity, unit length
  double min_height = 1;                         ///< of a frame, metres (>= 0)
  double max_thickness = 0.15; ///< of a leaf and its handles, metres (>= 0)
  double max_width =
      1.5; ///< of a leaf, and how far from its frame it may be; metres (>= 0)
  /** width of a leaf over that of its frame; half or less, for two of them (0 to 1) */
  double min_width_ratio = 0.4;
  /** how much larger than its frame a leaf may be, in width and height, and how much
   * lower; ratio (>= 1) */
  double max_ratio = 1.25;
  /** share of the frame's height along which the leaf stands within the wall, as it
   * hangs in its hinges, from 0 to 1 */
  double min_hinge = 0.6;
};

/** \brief Join the open leaf of a door with its frame, as a door is one thing. The leaf
 * stands out of the wall, so it bends away from the frame, but for the jamb in which it
 * hangs; that often goes with the leaf. A leaf is an upright segment, at least half of
 * which is before the wall, flat there and at 8 degrees to the wall or more. It has an
 * edge within the wall, beside a frame of its height and in its opening; edge and frame
 * together are as wide as the leaf, or, for doors with several leaves, wider. If the
 * frame is in pieces, all that the leaf fits into are joined with it. Leaves that open
 * away from the room are not found. No step of the thesis. The cost is linear in the
 * number of points, and in that of the points within the width of a leaf of each frame.
 * \param[in] points metres, local frame
 * \param[in] voxels of the points
 * \param[in] planes whose normals point into the room
 * \param[in] plane_of_voxel the number of its plane, from 1; 0 for objects
 * \param[in,out] segment_of_point numbered from 0; what is joined gets the number of
 * one of them
 * \return how many leaves were joined
 * \throws pcl::BadArgumentException if sizes differ or an option is out of range
 */
std::size_t
joinDoorLeaves(const std::vector<Eigen::Vector3f>& points,
               const SurfaceVoxels& voxels,
               const std::vector<StructurePlane>& planes,
               const std::vector<std::uint32_t>& plane_of_voxel,
               const DoorUnionOptions& options,
               std::vector<std::uint32_t>& segment_of_point);

} // namespace indoor
} // namespace pcl
