/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {

/** \brief Raise a voxel size to 2.5 times the resolution of the points, the factor of
 * Eq. (2.9), so that the voxels of a sparse surface touch.
 *
 * The resolution is the median distance to the nearest other point, from about two
 * thousand points: outliers do not change it. Where scans lie on one another, each
 * point with its copies at a fifth of the distance of others or less, the copies do
 * not count.
 *
 * \param[in] points finite points, metres, local frame
 * \return metres, at least the voxel size
 */
PCL_INDOOR_EXPORTS double
raisedToResolution(const std::vector<Eigen::Vector3f>& points, double voxel_size);

} // namespace pcl::indoor
