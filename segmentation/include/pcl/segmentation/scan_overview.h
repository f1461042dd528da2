/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl {
namespace indoor {

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
ScanOverview
scanOverview(const std::vector<Eigen::Vector3f>& points,
             const Eigen::Vector3f& up_axis = Eigen::Vector3f::UnitZ(),
             double metres_per_unit = 1.0);

} // namespace indoor
} // namespace pcl
