/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/surface_voxels.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief What counts as a straight bar. */
struct StraightBarOptions {
  double voxel_size = 0.03; ///< of the voxels, metres (> 0)
  /** bars run along those of these directions, orthonormal columns, that are level */
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ(); ///< against gravity, unit length
  double min_length = 1.5;                       ///< metres (>= 0)
  double min_elongation = 10; ///< length over the larger of the two widths (>= 1)
  double max_flatness = 1.75; ///< larger over smaller width; boards are flatter (>= 1)
  /** share of the length beside which there is nothing, from 0 to 1 */
  double min_clear = 0.35;
  double min_stretch = 1; ///< between two things that it runs into, metres (>= 0)
  double max_break = 1.5; ///< where it is within such a thing, over its width (>= 0)
  /** a bar with a larger share of its points in one segment is left there, from 0 to 1
   */
  double max_share = 0.9;
  /** but a thicker one, a beam, only if it is as large a share of that segment; metres
   * (>= 0) */
  double min_beam = 0.2;
};

/** \brief Make a segment of each straight level bar that runs through several segments:
 * a rail over its posts, a beam through columns. Each of them has got a piece of it,
 * but it goes on straight from one to the next, much longer than wide, with little
 * beside it. Only beams go on behind a break, and only if something fills it. Bars that
 * hardly have anything in what is no bar itself are things in line, as lamps, and stay
 * apart. What the bar held together falls into the parts that touch; parts above one
 * another, where it ran through, stay one, and crumbs go with the largest. No step of
 * the thesis. The cost is linear in the number of points, but for sorting, and once
 * more for each bar and each segment that it runs through.
 * \param[in] points metres, local frame
 * \param[in] voxels of the points
 * \param[in] left_out one flag per point; such points are in no bar
 * \param[in,out] segment_of_point numbered from 0; bars and parts get new numbers
 * \return how many bars were taken out
 * \throws pcl::BadArgumentException if sizes differ or an option is out of range
 */
std::size_t
partAtBars(const std::vector<Eigen::Vector3f>& points,
           const SurfaceVoxels& voxels,
           const std::vector<std::uint8_t>& left_out,
           const StraightBarOptions& options,
           std::vector<std::uint32_t>& segment_of_point);

} // namespace indoor
} // namespace pcl
