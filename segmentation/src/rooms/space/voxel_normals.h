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
 * voxels), and a thin wall that was seen from both sides gives one clean normal. Some
 * 10,000 voxels are looked at: enough for directions.
 *
 * \param[in] points the points that the grid was made of
 * \param[in] grid their occupancyGrid(); its values are not read
 * \param[in] threads 0 = automatic; the result does not depend on it
 * \return normals in the frame of the points, in the order of the voxels
 * \throws pcl::BadArgumentException if grid and points do not belong together or
 * threads is negative
 */
WeightedNormals
voxelNormals(const std::vector<Eigen::Vector3f>& points,
             const OccupancyGrid& grid,
             int threads = 0);

} // namespace pcl::indoor
