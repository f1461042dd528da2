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

  /** \brief Angle between the direction and +z, radians. */
  double
  tilt() const;

  /** \brief The up axis to segment with: exactly +z if the scan is level, as it is if
   * the direction was not found; else the direction. */
  Eigen::Vector3f
  upAxis() const;
};

/** \brief Find the vertical from floors, ceilings and walls.
 * Looks at a sample of the points, the same in any order; the result follows the points
 * if these are turned or scaled.
 * \param[in] points finite, in any unit; far outliers do no harm
 */
Vertical
findVertical(const std::vector<Eigen::Vector3f>& points);

} // namespace indoor
} // namespace pcl
