/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/rooms/vertical.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace indoor {
namespace {

/** Maps and floors are seldom more level than this; rooms come out the same. */
constexpr double level_tilt = 3.0 * M_PI / 180.0; // radians

} // namespace

double
Vertical::tilt() const
{
  return std::acos(std::clamp(static_cast<double>(direction.z()), -1.0, 1.0));
}

Eigen::Vector3f
Vertical::upAxis() const
{
  return is_found && tilt() > level_tilt ? direction : Eigen::Vector3f::UnitZ();
}

Vertical
findVertical(const std::vector<Eigen::Vector3f>&)
{
  return {};
}

} // namespace indoor
} // namespace pcl
