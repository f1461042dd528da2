/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief What counts as an empty gap through a segment. */
struct ObjectGapOptions {
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ(); ///< against gravity, unit length
  double voxel_size = 0.03; ///< of the voxels that made the segments, metres (> 0)
  double width = 0.5;       ///< least width of a gap, voxels (> 0)
  /** a gap holds at most this share of the points expected from the slices of its width
   * beside it, from 0 to 1: noise blurs its sides */
  double remainder = 0.25;
  /** and this many standard deviations of its number of points fewer (>= 0) */
  double deviations = 2;
  /** a gap is this many times as wide as any other stretch on either side that is as
   * empty, as far as four times its least width (>= 0), so that the gaps between the
   * lines of a scanner do not count */
  double prominence = 1.5;
  /** segments are looked at only if they occupy this many cells of half a voxel for
   * each voxel (>= 0), for the same reason: lines that bend leave no empty stretches */
  double min_density = 1.5;
  unsigned directions = 60; ///< of upright planes that are tried, in 180 degrees (>= 1)
  unsigned threads = 0;     ///< 0 = automatic; the result does not depend on it
};

/** \brief Part segments at narrow empty gaps: bookcases side by side, the two halves of
 * a double desk, chairs in a row. Voxels on both sides of a gap touch, and surfaces
 * that continue each other across it bend nothing; but an upright slice through the
 * whole segment that holds hardly any of its points, though the slices beside it hold
 * many, is no chance. What bridges a gap with less than a quarter of what stands beside
 * it counts as noise. A segment that reaches over more than 2^20 halves of a voxel is
 * left as it is. No step of the thesis. The cost is linear in the number of points
 * times directions.
 * \param[in] points finite, metres, local frame
 * \param[in] left_out one per point: such points (floor, walls) keep their segment
 * \param[in,out] segment_of_point numbered from 0; new segments follow those that were
 * there
 * \throws pcl::BadArgumentException if an option is out of range or sizes differ
 */
void
partAtGaps(const std::vector<Eigen::Vector3f>& points,
           const std::vector<std::uint8_t>& left_out,
           const ObjectGapOptions& options,
           std::vector<std::uint32_t>& segment_of_point);

} // namespace indoor
} // namespace pcl
