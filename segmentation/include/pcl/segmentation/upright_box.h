/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace indoor {

/** \brief A box that stands upright, turned about the vertical. */
struct UprightBox {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d size = Eigen::Vector3d::Zero(); ///< length >= width, and height
  double yaw = 0.0; ///< of the length, radians counter-clockwise from x, in [0, pi)
};

/** \brief The upright box of the least ground area around some points; z is up.
 *
 * One of its sides touches the convex hull along an edge. Time: n log n.
 * \param[in] points finite; of none, the box is all zero
 */
UprightBox
uprightBox(const std::vector<Eigen::Vector3d>& points);

/** \brief The distance of a place from a box, 0 inside. */
double
distanceTo(const UprightBox& box, const Eigen::Vector3d& place);

} // namespace indoor
} // namespace pcl
