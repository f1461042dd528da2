/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <optional>
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

/** \brief The metres per unit, of those that clouds come in, with which a length is
 * nearest to the height of a room.
 * \param[in] length along the upright axis, in the unit of the cloud (> 0)
 * \return that of metres, feet, inches, centimetres or millimetres
 */
double
likelyMetresPerUnit(double length);

/** \brief What the coordinates of a scan mean: which way is up, and how long a unit is.
 */
struct ScanCoordinates {
  Vertical vertical; ///< as the points tell it; not looked for where the axis is given
  Eigen::Vector3f up_axis = Eigen::Vector3f::UnitZ(); ///< that is used, unit length
  double metres_per_unit = 1.0;                       ///< that is used
};

/** \brief Find the vertical and the unit of a cloud, but for what is given.
 * \param[in] points finite
 * \param[in] up_axis of any length but 0
 * \param[in] metres_per_unit above 0
 */
ScanCoordinates
scanCoordinates(const std::vector<Eigen::Vector3f>& points,
                const std::optional<Eigen::Vector3f>& up_axis,
                std::optional<double> metres_per_unit);

} // namespace indoor
} // namespace pcl
