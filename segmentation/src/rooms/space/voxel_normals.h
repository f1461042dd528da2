/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/space/occupancy_grid.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Fewest points of a plane, and how flat they lie at least: (l2 - l1) / l3 of
 * their scatter with eigenvalues l1 <= l2 <= l3. */
constexpr int plane_points = 6;
constexpr double plane_flatness = 0.3;

struct VoxelNormalsOptions {
  int keep_one_in =
      0; ///< a normal for about every n-th occupied voxel (>= 0; 0 = so that
         ///< some 10,000 voxels are looked at: enough for directions)
  int min_points = plane_points;        ///< fewest points of a neighbourhood (>= 3)
  double min_flatness = plane_flatness; ///< of a neighbourhood, at least (0 ... 1)
  int threads = 0;                      ///< number of threads (>= 0; 0 = automatic)
};

/** \brief Unit normals without orientation, and how much each counts. */
struct WeightedNormals {
  std::vector<Eigen::Vector3d> normals;
  std::vector<double> weights; ///< > 0
};

/** \brief Surface normals of a cloud at the resolution of a voxel grid.
 *
 * The scatter of the points is summed up per voxel, and a normal is the direction of
 * the least scatter in a neighbourhood of 3 x 3 x 3 voxels; its weight is the flatness
 * there, so that a surface counts by its area and not by its point density. Meant for
 * statistics of directions: much faster than normals of points (linear in points and
 * voxels), and a thin wall that was seen from both sides gives one clean normal.
 *
 * \param[in] points the points that the grid was made of
 * \param[in] grid their occupancyGrid(); its values are not read
 * \return normals in the frame of the points, in the order of the voxels
 * \throws pcl::BadArgumentException if grid and points do not belong together or an
 * option is out of range
 */
WeightedNormals
voxelNormals(const std::vector<Eigen::Vector3f>& points,
             const OccupancyGrid& grid,
             const VoxelNormalsOptions& options = {});

} // namespace pcl::indoor
