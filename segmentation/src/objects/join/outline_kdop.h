/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/join/kdop.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace pcl::indoor {

/** \brief An outline seen from above as a convex polygon, a k-DOP: its support in
 * sixteen level directions, metres; direction i is turned by i * 22.5 degrees. */
using KDop16 = KDop<16>;

/** \brief Get a direction, unit length.
 * \param[in] i 0 ... 15 */
Eigen::Vector2d
outlineDirection(std::size_t i);

/** \brief Get the area, m^2; 0 if the polygon is empty. */
double
outlineArea(const KDop16& outline);

/** \brief Part of a line. */
struct OutlineSpan {
  double low = 0, high = -1; ///< metres; high < low: empty

  bool
  contains(double y) const
  {
    return low <= y && y <= high;
  }
};

/** \brief Get where a line along y crosses an outline. */
OutlineSpan
outlineSpan(const KDop16& outline, double x);

/** \brief A rectangle around an outline, with two of the directions as its axes. */
struct OutlineRectangle {
  std::size_t axis = 0; ///< direction 0 ... 3; the other axis is axis + 4
  double length = 0;    ///< along it, metres
  double width = 0;     ///< across it, metres
};

/** \brief Get the smallest of the four rectangles around an outline. */
OutlineRectangle
outlineRectangle(const KDop16& outline);

} // namespace pcl::indoor
