/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/indoor/point_cells.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {

/** \brief Median distance of points to their nearest other points, from about two
 * thousand of them: a resolution that outliers do not change, without a search tree.
 * \param[in] points finite points, metres, local frame
 * \param[in] cells the points in cells of any size
 * \return metres; infinity if most points have no other in their cell and those around
 */
PCL_INDOOR_EXPORTS double
medianResolution(const std::vector<Eigen::Vector3f>& points, const PointCells& cells);

/** \brief Raise a voxel size to 2.5 times the resolution of the points, the factor of
 * Eq. (2.9), so that the voxels of a sparse surface touch. Where scans lie on one
 * another, each point with its copies at a fifth of the distance of others or less, the
 * copies do not count.
 * \return metres, at least the voxel size
 */
PCL_INDOOR_EXPORTS double
raisedToResolution(const std::vector<Eigen::Vector3f>& points, double voxel_size);

} // namespace pcl::indoor
