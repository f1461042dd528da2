/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pcl {
namespace indoor {

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

} // namespace indoor
} // namespace pcl
