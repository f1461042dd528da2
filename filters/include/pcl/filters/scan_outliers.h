/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor {

struct ScanOutlierOptions {
  /** R: a point with too few others within it is removed, metres; 0: by the rule of Eq.
   * (2.9), see neighborhoodRadius() */
  double radius = 0;
  int min_neighbors = 2; ///< within the radius; 0: do not look at the radius
  int mean_k = 8;        ///< k of Eq. (2.1): neighbours whose mean distance counts
  /** removed are points whose mean distance is this many standard deviations above the
   * mean of all (> 0); infinity: do not look at distances */
  double deviations = 3;
  /** and at least this many times that mean (>= 1): where the density hardly varies,
   * the borders of surfaces would be outliers otherwise */
  double least_ratio = 2;
  unsigned threads = 0; ///< for the radius; 0 = automatic
};

/** \brief Find what is wrong with the options.
 * \return one sentence with parameter, value and unit; empty if nothing is
 */
PCL_INDOOR_EXPORTS std::string
findProblem(const ScanOutlierOptions& options);

/** \brief Find the points of reflections and sensor noise that lie alone (Sec.
 * 2.1.5.1), with pcl::RadiusOutlierRemoval and then, on what is left, by the rule of
 * pcl::StatisticalOutlierRemoval: in this order far outliers cannot raise the standard
 * deviation. Several points in exactly one place are as one.
 * \param[in] points finite points, metres, local frame
 * \return one flag per point, 1 for outliers
 * \throws pcl::BadArgumentException if an option is out of range
 */
PCL_INDOOR_EXPORTS std::vector<std::uint8_t>
scanOutliers(const std::vector<Eigen::Vector3f>& points,
             const ScanOutlierOptions& options);

} // namespace pcl::indoor
