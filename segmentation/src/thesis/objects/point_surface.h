/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/surface_voxels.h"

#include <pcl/indoor/point_cells.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Make each point a voxel of its own: what works on voxels then works on
 * points. Neighbours, normals and curvatures are left empty. */
SurfaceVoxels
pointsAsVoxels(const std::vector<Eigen::Vector3f>& points);

/** \brief Estimate normals and curvatures by principal component analysis of all points
 * within a radius, Eq. (2.3) to (2.5) with all weights 1, and (2.8). The sign of a
 * normal is arbitrary; where there are fewer than three points it is zero.
 * \param[in,out] surface as made by pointsAsVoxels() */
void
estimatePointNormals(double radius, unsigned threads, SurfaceVoxels& surface);

/** \brief Convert a colour of the standard sRGB (IEC 61966-2-1) to CIELab with the
 * white D65: white is (100, 0, 0).
 * \param[in] rgb red, green and blue, 0 to 255
 */
Eigen::Vector3f
labOfRgb(const Eigen::Vector3f& rgb);

/** \brief List the points within a radius of some of them, without themselves.
 * \param[in] wanted one flag per point; others have no neighbours
 */
Adjacency
neighborsWithin(const std::vector<Eigen::Vector3f>& points,
                double radius,
                const std::vector<std::uint8_t>& wanted);

} // namespace pcl::indoor
