/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

namespace pcl::indoor {

/** \brief Two directions along the ground and the one up, as rows. */
inline Eigen::Matrix3d
groundFrame(const Eigen::Vector3f& up)
{
  Eigen::Matrix3d frame;
  frame.row(2) = up.cast<double>().transpose();
  const Eigen::Vector3d along = up.cast<double>().unitOrthogonal();
  frame.row(0) = along.transpose();
  frame.row(1) = frame.row(2).cross(frame.row(0));
  return frame;
}

/** Directions along the ground that are tried, in 180 degrees. */
constexpr unsigned level_directions = 60;

/** \brief Get one of these directions, unit length.
 * \param[in] i 0 ... level_directions - 1 */
inline Eigen::Vector2f
levelDirection(unsigned i)
{
  const double angle = M_PI * i / level_directions;
  return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

} // namespace pcl::indoor
