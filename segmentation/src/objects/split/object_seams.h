/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/objects/surface_voxels.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief What counts as a seam between two bodies that stand against each other. */
struct ObjectSeamOptions {
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ(); ///< against gravity, unit length
  double voxel_size = 0.03; ///< of the voxels that made the segments, metres (> 0)
  /** an upright slice of one voxel at a seam holds this many times the points of those
   * beside it, from one voxel to three away (>= 1) */
  double density = 1.8;
  /** the slices beside it hold at least this share of each other, from 0 to 1: the
   * segment goes on, on both sides */
  double balance = 0.5;
  double min_side = 0.35; ///< the segment reaches this far on both sides, metres (>= 0)
  double cover = 0.3;     ///< share of the inside that a seam fills, from 0 to 1
  double min_depth = 2;   ///< of the inside, cells of a voxel (>= 0)
  /** share of a seam's cells, outside of what either side fills, that are inside: the
   * side of a desk's drawers is not, but for strays in the space for the knees; from 0
   * to 1 */
  double enclosed = 0.15;
  unsigned min_cells = 8; ///< of a voxel that a seam fills there (>= 1)
  /** share of the points on either side whose normals point away from the inside, from
   * 0 to 1 */
  double outward = 0.5;
  unsigned directions = 60; ///< of upright planes that are tried, in 180 degrees (>= 1)
  unsigned threads = 0;     ///< 0 = automatic; the result does not depend on it
};

/** \brief Part segments at the seams between closed bodies that stand against each
 * other without a gap, as the cabinets of a kitchen. Their fronts and tops go on and
 * bend nothing, but a scan sees some of the sides that face each other: an upright
 * sheet of points where there should be none, in the inside of the segment. A cell of
 * the section is inside if neither side has points there, but both have some above it,
 * or both below, and both before it, or both behind. The compartments of a shelf are
 * open, and the normals around them point into them.
 *
 * The cut is amid the sheet; if it goes on outside of what one side encloses, as the
 * side of a refrigerator above a worktop, it belongs to the other. No step of the
 * thesis. A segment that reaches over more than 4096 voxels is left as it is. The cost
 * is linear in the number of points times directions.
 * \param[in] points finite, metres, local frame
 * \param[in] voxels of the points, with oriented normals
 * \param[in] left_out one per point: such points (floor, walls) keep their segment
 * \param[in,out] segment_of_point numbered from 0; new segments follow those that were
 * there
 * \throws pcl::BadArgumentException if an option is out of range or sizes differ
 */
void
partAtSeams(const std::vector<Eigen::Vector3f>& points,
            const SurfaceVoxels& voxels,
            const std::vector<std::uint8_t>& left_out,
            const ObjectSeamOptions& options,
            std::vector<std::uint32_t>& segment_of_point);

} // namespace indoor
} // namespace pcl
