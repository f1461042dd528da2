/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/objects/surface_voxels.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief What counts as a thing that lies on a surface. */
struct FlatThingOptions {
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ(); ///< against gravity, unit length
  double voxel_size =
      0.03; ///< of the voxels, and of the cells of heights, metres (> 0)
  /** metres (> 0); a thing with more than 30 % of its points above this has sides that
   * part it */
  double max_height = 0.12;
  double min_surface = 64; ///< area of the surface, voxels (>= 1)
  double min_area = 4;     ///< area of a thing, voxels (>= 1)
  /** area of a thing over that of the surface, with what is lower than a voxel (> 0) */
  double max_area_share = 0.25;
  double min_surrounded = 0.5; ///< share of the cells at its rim with points (0 to 1)
  /** a thing rises this many standard deviations of the surface's heights (> 0) */
  double deviations = 3;
  double min_rise = 0.1; ///< and at least this, voxels (> 0)
};

/** \brief Part flat things from the horizontal surface that they lie on: keyboards,
 * stacks of paper, the foot of a monitor. They are lower than a few voxels, so that
 * their sides bend no normals; but the mean height of the many points of a cell tells
 * them from the surface. They lie on it: it goes on around them, and is larger. The
 * largest horizontal surface of each segment is looked at; one whose box holds more
 * than 2^22 cells is left as it is. No step of the thesis. The cost is linear in the
 * number of points, but for a sort of heights.
 * \param[in] points that the voxels were made of
 * \param[in] voxels with normals
 * \param[in] segment_of_voxel numbered from 0
 * \param[in] left_out one per voxel; segments of such voxels (floor, walls) stay whole
 * \return one segment per point; the things follow the segments that were there
 * \throws pcl::BadArgumentException if an option is out of range or sizes differ
 */
std::vector<std::uint32_t>
partFlatThings(const std::vector<Eigen::Vector3f>& points,
               const SurfaceVoxels& voxels,
               const std::vector<std::uint32_t>& segment_of_voxel,
               const std::vector<std::uint8_t>& left_out,
               const FlatThingOptions& options);

} // namespace indoor
} // namespace pcl
