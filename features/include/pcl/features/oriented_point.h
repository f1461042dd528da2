/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {

/** \brief A point of a surface and the surface's normal there (a "surflet"). */
struct OrientedPoint {
  Eigen::Vector3f position = Eigen::Vector3f::Zero(); ///< metres, local frame
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();   ///< unit length
};

/** \brief Where it is. */
inline const Eigen::Vector3f&
positionOf(const OrientedPoint& point)
{
  return point.position;
}

/** \brief Largest distance found between two points: the size of an object however it
 * is turned.
 *
 * Walks from the point farthest from the centroid to the point farthest from that one,
 * and on while the distance grows, a few times through the points in all. At least 1 /
 * sqrt(3) of the true diameter, and for most shapes the diameter itself.
 * \return metres; 0 for no point, one point, or points all in one place
 */
PCL_INDOOR_EXPORTS float
objectExtent(const std::vector<OrientedPoint>& points);

/** \brief Tell whether an object of this extent can be described: it has one, and not
 * a larger one than usable points have, see isUsable(). */
PCL_INDOOR_EXPORTS bool
isUsableExtent(float extent);

} // namespace pcl::indoor
