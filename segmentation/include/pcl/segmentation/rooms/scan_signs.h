/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace indoor {

/** \brief What the points of a building tell about their unit and about which axis is
 * upright; both follow the points if these are scaled or if their axes change places.
 */
struct ScanSigns {
  /** Per axis: half of the free space along it lies between surfaces that are at least
   * so far apart, in the unit of the points; along the upright axis that is the height
   * of the rooms. 0 = not known. */
  Eigen::Vector3d free_length = Eigen::Vector3d::Zero();
  /** Per axis: how much of all surface lies, on average, in the same plane across this
   * axis as a piece of surface, over the free length. Floors and ceilings lie in few
   * planes with little space between them, so the upright axis has the largest value. 0
   * = not known. */
  Eigen::Vector3d uprightness = Eigen::Vector3d::Zero();

  /** \brief 0, 1 or 2: the axis that is clearly more upright than the last one; the
   * last one if there is none. */
  int
  uprightAxis() const;
};

/** \brief Look at some 15,000 of the points, the same in any order.
 * \param[in] points finite; far outliers do no harm
 * \return all 0 if there are too few points
 */
ScanSigns
scanSigns(const std::vector<Eigen::Vector3f>& points);

/** \brief The metres per unit, of those that clouds come in, with which a length is
 * nearest to the height of a room.
 * \param[in] length along the upright axis, in the unit of the cloud (> 0)
 * \return that of metres, feet, inches, centimetres or millimetres
 */
double
likelyMetresPerUnit(double length);

} // namespace indoor
} // namespace pcl
