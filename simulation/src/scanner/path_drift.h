/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/carried_path.h>
#include <pcl/simulation/random_draw.h>

#include <vector>

namespace pcl::indoor {

/** \brief What a map that was made on the way is wrong by. */
struct PoseError {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< metres
  double turn = 0.0;                               ///< about z, radians
};

/** \brief The error of registration along a path that a closed loop has spread.
 *
 * Position and heading walk at random with the way, half as much in z; what they are
 * wrong by at the end is taken off in proportion to the way, so that the error is 0 at
 * both ends (a Brownian bridge) and largest half way.
 */
class PathDrift {
public:
  /** \param[in] drift standard deviation of x and y after 10 m without a closed loop,
   * metres; that of the heading moves points 5 m away as far */
  PathDrift(const CarriedPath& path, double drift, RandomDraw draw);

  PoseError
  at(double time) const;

private:
  std::vector<PoseError> errors_; // at the path's points
  double step_ = 1.0;             // seconds between them
};

} // namespace pcl::indoor
