/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/polygon.h>

#include <cmath>

namespace pcl::indoor {

/** \brief The corners of a rectangle about a place, turned, counter-clockwise.
 * \param[in] size its width and depth, metres
 * \param[in] rotation radians */
inline Polygon
turnedRectangle(const Eigen::Vector2d& at, const Eigen::Vector2d& size, double rotation)
{
  const double c = std::cos(rotation), s = std::sin(rotation);
  const Eigen::Vector2d x = size.x() / 2 * Eigen::Vector2d(c, s);
  const Eigen::Vector2d y = size.y() / 2 * Eigen::Vector2d(-s, c);
  return {at - x - y, at + x - y, at + x + y, at - x + y};
}

} // namespace pcl::indoor
