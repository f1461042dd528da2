/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/join/outline_kdop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace {

using pcl::indoor::KDop16;

using Corner = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;
using Directions = std::array<Corner, std::tuple_size<KDop16>::value>;

const Directions&
directions()
{
  static const auto all = [] {
    Directions made;
    for (std::size_t d = 0; d < made.size(); ++d) {
      const double angle = 2 * M_PI * static_cast<double>(d) / made.size();
      made[d] = {std::cos(angle), std::sin(angle)};
    }
    return made;
  }();
  return all;
}

} // namespace

namespace pcl::indoor {

Eigen::Vector2d
outlineDirection(std::size_t i)
{
  return directions()[i];
}

double
outlineArea(const KDop16& outline)
{
  const double x0 = -outline[8], x1 = outline[0], y0 = -outline[12], y1 = outline[4];
  if (!(x1 > x0) || !(y1 > y0))
    return 0;
  // the box first, the other faces cut its corners
  std::array<Corner, 40> corners{
      Corner(x0, y0), Corner(x1, y0), Corner(x1, y1), Corner(x0, y1)},
      kept;
  std::size_t count = 4;
  for (std::size_t d = 0; d < outline.size(); ++d) {
    if (d % 4 == 0)
      continue;
    std::size_t kept_count = 0;
    const auto above = [&](const Corner& p) {
      return directions()[d].dot(p) - outline[d];
    };
    for (std::size_t i = 0; i < count; ++i) {
      const auto& here = corners[i];
      const auto& next = corners[i + 1 == count ? 0 : i + 1];
      const double h = above(here), n = above(next);
      if (h <= 0)
        kept[kept_count++] = here;
      if ((h < 0 && n > 0) || (h > 0 && n < 0)) {
        const double t = h / (h - n);
        kept[kept_count++] = here + t * (next - here);
      }
    }
    count = kept_count;
    std::swap(corners, kept);
    if (count < 3)
      return 0;
  }
  double twice = 0;
  for (std::size_t i = 2; i < count; ++i) {
    const Corner u = corners[i - 1] - corners[0], v = corners[i] - corners[0];
    twice += u.x() * v.y() - u.y() * v.x();
  }
  return twice / 2;
}

OutlineSpan
outlineSpan(const KDop16& outline, double x)
{
  if (x > outline[0] || x < -outline[8])
    return {};
  constexpr double far = std::numeric_limits<double>::infinity();
  OutlineSpan span{-far, far};
  for (std::size_t d = 1; d < 8; ++d) // to larger y
    span.high = std::min(span.high,
                         (outline[d] - directions()[d].x() * x) / directions()[d].y());
  for (std::size_t d = 9; d < 16; ++d)
    span.low = std::max(span.low,
                        (outline[d] - directions()[d].x() * x) / directions()[d].y());
  return span;
}

OutlineRectangle
outlineRectangle(const KDop16& outline)
{
  OutlineRectangle smallest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t d = 0; d < 4; ++d) {
    const double length = outline[d] + outline[d + 8],
                 width = outline[d + 4] + outline[d + 12];
    if (length * width < least) {
      least = length * width;
      smallest = {d, length, width};
    }
  }
  return smallest;
}

} // namespace pcl::indoor
