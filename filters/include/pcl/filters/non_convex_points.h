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

struct NonConvexityOptions {
  /** R, radius of the neighbourhood, metres (>= 0); 0: by the rule of Eq. (2.9), see
   * neighborhoodRadius() */
  double radius = 0;
  /** theta_t: points whose curvature is not above it are never non-convex (0 to 1/3) */
  float curvature_threshold = 0.03f;
  /** alpha_t: non-convex are points with N+ >= alpha_t * N- (0 to 1) */
  float ratio_threshold = 0.2f;
  unsigned threads = 0; ///< 0 = automatic
};

/** \brief Find what is wrong with the options.
 * \return one sentence with parameter, value and unit; empty if nothing is
 */
PCL_INDOOR_EXPORTS std::string
findProblem(const NonConvexityOptions& options);

/** \brief Decide from the numbers of neighbours in the two half-spaces of the tangent
 * plane, Eq. (4.2): true (concave or ambiguous) if N+ >= alpha_t * N-.
 * \param[in] positive N+, neighbours on the side of the normal
 * \param[in] negative N-, neighbours on the other side
 */
inline bool
isNonConvex(double positive, double negative, double ratio_threshold)
{
  return positive >= ratio_threshold * negative;
}

/** \brief Find the points of concave and of noisy regions (Sec. 4.2.1, Eq. (4.2)).
 * A point is found if its curvature is above the threshold and at least alpha_t as many
 * neighbours lie in front of its tangent plane as behind it. Points on the plane, the
 * point itself among them, count for neither side.
 * Cost is linear in the number of points above the curvature threshold.
 * \param[in] points finite points, metres, local frame
 * \param[in] normals unit normals pointing out of the objects, one per point
 * \param[in] curvatures surface variation of Eq. (2.8), one per point
 * \return one flag per point, 1 for non-convex; points with non-finite normal or
 * curvature are not
 * \throws pcl::BadArgumentException if sizes differ or an option is out of range
 */
PCL_INDOOR_EXPORTS std::vector<std::uint8_t>
nonConvexPoints(const std::vector<Eigen::Vector3f>& points,
                const std::vector<Eigen::Vector3f>& normals,
                const std::vector<float>& curvatures,
                const NonConvexityOptions& options);

} // namespace pcl::indoor
