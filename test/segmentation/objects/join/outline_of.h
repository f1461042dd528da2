/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/join/outline_kdop.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::indoor {
namespace test {

using Places = std::vector<Eigen::Vector3f>;

/** How far all of the places reach, by the letter. */
inline KDop16
outlineOf(const Places& places, float margin = 0)
{
  KDop16 outline;
  for (std::size_t d = 0; d < 16; ++d) {
    const float angle = static_cast<float>(d) * static_cast<float>(M_PI) / 8;
    const Eigen::Vector3f direction(std::cos(angle), std::sin(angle), 0);
    outline[d] = -1e9f;
    for (const auto& place : places)
      outline[d] = std::max(outline[d], direction.dot(place) + margin);
  }
  return outline;
}

/** Whether a place is inside, by the letter. */
inline bool
isWithin(const KDop16& outline, double x, double y)
{
  for (std::size_t d = 0; d < outline.size(); ++d)
    if (outlineDirection(d).dot(Eigen::Vector2d(x, y)) > outline[d])
      return false;
  return true;
}

/** The outline of a level rectangle. */
inline KDop16
rectangle(float x0, float y0, float x1, float y1)
{
  return outlineOf({{x0, y0, 0}, {x1, y0, 0}, {x0, y1, 0}, {x1, y1, 0}});
}

} // namespace test
} // namespace pcl::indoor
