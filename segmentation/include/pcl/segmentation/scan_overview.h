/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

// What can be told of a scan before its rooms are looked for.

namespace pcl::indoor {

/** \brief Which way is up in a scan, in the frame of its points. */
struct PCL_INDOOR_EXPORTS Vertical {
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
PCL_INDOOR_EXPORTS Vertical
findVertical(const std::vector<Eigen::Vector3f>& points);

/** \brief The vertical of a scan whose up axis is known, with the height of its rooms.
 * \param[in] up_axis of any length but 0
 */
PCL_INDOOR_EXPORTS Vertical
verticalAlong(const Eigen::Vector3f& up_axis,
              const std::vector<Eigen::Vector3f>& points);

/** \brief The metres per unit, of those that clouds come in, with which a length is
 * nearest to the height of a room.
 * \param[in] length along the upright axis, in the unit of the cloud (> 0)
 * \return that of metres, feet, inches, centimetres or millimetres
 */
PCL_INDOOR_EXPORTS double
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
PCL_INDOOR_EXPORTS ScanCoordinates
scanCoordinates(const std::vector<Eigen::Vector3f>& points,
                const std::optional<Eigen::Vector3f>& up_axis,
                std::optional<double> metres_per_unit);

/** \brief What can be told of a scan before any work: is there what rooms are found
 * from? All lengths in metres. Shares are of places in the plan, storey by storey: what
 * the scan covers or encloses, but for the walls. */
struct ScanOverview {
  double spacing = 0.0; ///< a point per square of this side, on half of the surface; 0
                        ///< = not known
  Eigen::Vector3d extent = Eigen::Vector3d::Zero(); ///< along the axes of the points, z
                                                    ///< up; without stray points
  std::size_t storeys = 0;
  double area = 0.0;         ///< of these places, m^2
  double open_area = 0.0;    ///< of others, without walls around them: outdoors, m^2
  double floor_seen = 0.0;   ///< share of the places with a floor
  double ceiling_seen = 0.0; ///< share of the places with something above
  double wall_sides = 0.0;   ///< sides on which a place has a wall, up to 4, mean
  double room_height = 0.0;  ///< of half of the places with floor and ceiling; 0 = none
  double duplicates = 0.0;   ///< share of the points that are where another one is
};

/** \brief Look at 200,000 of the points or a quarter, the same in any order.
 *
 * Columns of a coarse grid have a floor, a ceiling, both, or are walls, by their
 * occupied voxels. Floors go on over at least 4 m^2, level or leaning, as no furniture
 * does; under that it is not known whether there is one. What is less than 1 m high is
 * a slice, of which no more is told than its extent.
 * \param[in] points finite; far outliers do no harm
 * \param[in] up_axis of any length but 0, in the frame of the points
 * \param[in] metres_per_unit of the points (> 0)
 * \return all 0 if there are no points
 */
PCL_INDOOR_EXPORTS ScanOverview
scanOverview(const std::vector<Eigen::Vector3f>& points,
             const Eigen::Vector3f& up_axis = Eigen::Vector3f::UnitZ(),
             double metres_per_unit = 1.0);

} // namespace pcl::indoor
