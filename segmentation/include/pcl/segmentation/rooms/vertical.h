/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace indoor {

/** \brief Which way is up in a scan, in the frame of its points. */
struct Vertical {
  /** Of unit length, as measured; +z if it was not found. */
  Eigen::Vector3f direction = Eigen::Vector3f::UnitZ();
  /** Floors, ceilings and walls agree on it; else the scan is taken as it is. */
  bool is_found = false;
  /** Furniture tells the floors from the ceilings, or +z does. */
  bool is_end_known = false;
  bool is_furnished = false; ///< clearly
  bool has_rooms = false;    ///< most columns have floor and ceiling
  /** Where it was not found: the scan seems to lie on its side, along this direction;
   * zero if not. */
  Eigen::Vector3f doubtful = Eigen::Vector3f::Zero();
  /** Half of the free space along the direction lies between surfaces that are at least
   * so far apart, in the unit of the points; 0 = not known. */
  double room_height = 0.0;

  /** \brief Angle between the direction and +z, radians. */
  double
  tilt() const;

  /** \brief The up axis to segment with: the direction, but exactly an axis of the
   * points where that is less than 1 degree away; +z if the direction was not found.
   */
  Eigen::Vector3f
  upAxis() const;

  /** \brief The same with its other end up, which is known to be so. */
  Vertical
  reversed() const
  {
    Vertical vertical = *this;
    vertical.direction = -direction;
    vertical.is_found = vertical.is_end_known = true;
    vertical.doubtful.setZero();
    return vertical;
  }
};

/** \brief Find the vertical from floors, ceilings and walls.
 * Looks at a sample of the points, the same in any order; the result follows the points
 * if these are turned or scaled.
 * \param[in] points finite, in any unit; far outliers do no harm
 */
Vertical
findVertical(const std::vector<Eigen::Vector3f>& points);

/** \brief The vertical of a scan whose up axis is known, with the height of its rooms.
 * \param[in] up_axis of any length but 0
 */
Vertical
verticalAlong(const Eigen::Vector3f& up_axis,
              const std::vector<Eigen::Vector3f>& points);

} // namespace indoor
} // namespace pcl
