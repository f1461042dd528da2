/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace pcl {
namespace indoor {

/** \brief An outline seen from above as a convex polygon: how far it reaches in sixteen
 * level directions, metres; direction i is turned by i * 22.5 degrees. */
using OutlineReach = std::array<float, 16>;

/** \brief Get a direction, unit length.
 * \param[in] i 0 ... 15 */
Eigen::Vector2d
outlineDirection(std::size_t i);

/** \brief Get the area, m^2; 0 if the polygon is empty. */
double
outlineArea(const OutlineReach& reach);

/** \brief Get the outline of two together. */
OutlineReach
outlineOfBoth(const OutlineReach& a, const OutlineReach& b);

/** \brief Get what two outlines have in common. */
OutlineReach
commonOutline(const OutlineReach& a, const OutlineReach& b);

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
outlineSpan(const OutlineReach& reach, double x);

/** \brief A rectangle around an outline, with two of the directions as its axes. */
struct OutlineRectangle {
  std::size_t axis = 0; ///< direction 0 ... 3; the other axis is axis + 4
  double length = 0;    ///< along it, metres
  double width = 0;     ///< across it, metres
};

/** \brief Get the smallest of the four rectangles around an outline. */
OutlineRectangle
outlineRectangle(const OutlineReach& reach);

} // namespace indoor
} // namespace pcl
