/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/plan.h>

#include <Eigen/Geometry>

namespace pcl::indoor::test {

/** Where furniture stands. */
inline Polygon
footprintOf(const FurniturePlan& item)
{
  const Eigen::Rotation2Dd turn(item.rotation);
  const double x = item.size->x() / 2, y = item.size->y() / 2;
  return {item.at + turn * Eigen::Vector2d(-x, -y),
          item.at + turn * Eigen::Vector2d(x, -y),
          item.at + turn * Eigen::Vector2d(x, y),
          item.at + turn * Eigen::Vector2d(-x, y)};
}

} // namespace pcl::indoor::test
