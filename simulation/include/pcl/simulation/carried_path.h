/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/simulation/trajectory.h>

#include <vector>

namespace pcl::indoor {

/** \brief How a sensor is carried through a building. */
struct PathOptions : TrajectoryOptions { // its spacing: between neighbouring stops
  double speed = 0.8;                    ///< metres per second (0.05 ... 20)
  double entered = 1.0;     ///< share of the rooms that are entered (0 ... 1)
  bool look_around = false; ///< turn about once at every stop
  std::uint32_t seed = 1;   ///< draws the rooms that are not entered
};

/** \brief Where the carried sensor is at a time. */
struct PathPoint {
  double time = 0.0;        ///< seconds from the start of the path
  double way = 0.0;         ///< metres from the start of the path
  Eigen::Vector3d position; ///< of the sensor, metres
  double floor = 0.0;       ///< height that the carrier stands on, metres
  double heading = 0.0;     ///< radians from +x, counter-clockwise, not wrapped
};

/** \brief A way in time; its points are 0.1 s apart. */
using CarriedPath = std::vector<PathPoint>;

/** \brief Plan a way that ends where it begins through each storey of a building.
 *
 * The stops are those of planTrajectory() within rooms. From each, the way goes to the
 * nearest one left, through doorways that are open, round furniture and through the
 * middle of the free space, and at last back to the first. Of each storey only the part
 * is entered that is joined by doorways and has the largest floor; platforms and stairs
 * are not. Where only a share of the rooms is entered (rounded up), the others are
 * drawn from those that leave the rest joined: they are seen through their doors.
 * \return one path for each storey that has a free place
 * \throws BadArgumentException if an option is out of its range
 */
PCL_INDOOR_EXPORTS std::vector<CarriedPath>
planPaths(const Building& building, const PathOptions& options);

/** \brief The way straight through some positions, in their order.
 * \throws BadArgumentException if an option is out of its range
 */
PCL_INDOOR_EXPORTS CarriedPath
pathThrough(const std::vector<Eigen::Vector3d>& positions, const PathOptions& options);

/** \brief The point of a path at a time, between its points; before and after it, its
 * ends. The path must have a point. */
PCL_INDOOR_EXPORTS PathPoint
placeAt(const CarriedPath& path, double time);

} // namespace pcl::indoor
