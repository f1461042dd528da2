/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>

namespace pcl::indoor {

/** \brief Parameters of multiScaleNormals(). */
struct MultiScaleNormalOptions {
  /** of the largest neighbourhood, metres (>= 0); 0: twice that of Eq. (2.9), about 50
   * points */
  double radius = 0;
  unsigned scales = 4;  ///< radii that are tried, down to half of the largest (1 to 16)
  unsigned threads = 0; ///< 0 = automatic; the result does not depend on it
};

/** \brief Find what is wrong with the options.
 * \return one sentence with parameter, value and unit; empty if nothing is
 */
PCL_INDOOR_EXPORTS std::string
findProblem(const MultiScaleNormalOptions& options);

/** \brief Estimate normals by planes of least squares at several scales (Sec. 2.1.5.2).
 *
 * Of some neighbourhoods of a point, the one with the least curvature, Eq. (2.8),
 * decides: the largest on smooth surfaces, where more points mean less noise, and a
 * smaller one near edges, where the larger ones reach over them. With one scale this is
 * what NormalEstimation computes. Cost: a search of neighbours per place.
 * \param[in] points metres, local frame; those that are not finite get no normal
 * \return one per point, of unit length, sign arbitrary, with its curvature; NaN where
 * there are fewer than three neighbours, itself among them, or all are on a line
 * \throws pcl::BadArgumentException if an option is out of range
 */
PCL_INDOOR_EXPORTS PointCloud<Normal>
multiScaleNormals(const PointCloud<PointXYZ>& points,
                  const MultiScaleNormalOptions& options = {});

} // namespace pcl::indoor
