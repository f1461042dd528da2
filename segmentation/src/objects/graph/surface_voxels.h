/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/surface_appearance.h"

#include <pcl/indoor/exports.h>
#include <pcl/indoor/point_cells.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief The occupied voxels of a scanned surface, with the local geometry of each.
 * All arrays have one entry per voxel; positions are in the frame of the points.
 */
struct SurfaceVoxels {
  PointCells cells;                       ///< which points are in which voxel
  Adjacency neighbors;                    ///< the up to 26 occupied voxels around
  std::vector<Eigen::Vector3f> centroids; ///< mean of the points
  std::vector<Eigen::Vector3f> normals;   ///< unit length; zero where none is defined
  std::vector<float> curvatures;          ///< surface variation, Eq. (2.8)
  SurfaceAppearance appearance;           ///< unless it is not used

  /** \brief Get the number of voxels. */
  std::size_t
  size() const
  {
    return centroids.size();
  }
};

/** \brief Gather points into voxels and connect voxels that touch.
 * Normals and curvatures are left empty.
 * \param[in] points finite points, metres, local frame
 * \param[in] grid_points where the points lie for the purpose of the grid, one per
 * point; empty for the points themselves
 * \param[in] voxel_size edge of a voxel in the unit of grid_points, positive
 * \throws pcl::BadArgumentException as groupByCell() does
 */
PCL_INDOOR_EXPORTS SurfaceVoxels
surfaceVoxels(const std::vector<Eigen::Vector3f>& points,
              const std::vector<Eigen::Vector3f>& grid_points,
              double voxel_size);

/** \brief Estimate normal and curvature of each voxel by principal component analysis
 * of the points in it and in the voxels that touch it (Sec. 2.1.5.2), from summed
 * moments, without a search: a parallel surface behind a gap has no influence. The sign
 * of a normal is arbitrary.
 * \param[in] points as given to surfaceVoxels()
 * \param[in] threads 0 = automatic; the result does not depend on it
 */
PCL_INDOOR_EXPORTS void
estimateNormals(const std::vector<Eigen::Vector3f>& points,
                SurfaceVoxels& voxels,
                unsigned threads);

/** \brief Average the points' normals in each voxel instead, and keep their sign.
 * \param[in] point_normals one per point; what has not length 1 is left out
 */
void
averageNormals(const std::vector<Eigen::Vector3f>& point_normals,
               SurfaceVoxels& voxels);

} // namespace pcl::indoor
