/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/join/direction_hull.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace {

constexpr std::size_t face_count = std::tuple_size<pcl::indoor::KDop50>::value;

/** A convex polygon, its corners in order: a square that the other faces cut, each of
 * which adds a corner at most. */
struct Polygon {
  std::array<double, face_count + 4> x, y;
  std::size_t size = 0;

  void
  add(double corner_x, double corner_y)
  {
    x[size] = corner_x;
    y[size++] = corner_y;
  }
};

using Heights = std::array<double, face_count + 4>;

/** Keep of a polygon what is on or below a line, whose heights its corners have. */
void
clip(const Polygon& corners, const Heights& heights, Polygon& kept)
{
  kept.size = 0;
  for (std::size_t i = 0; i < corners.size; ++i) {
    const std::size_t next = i + 1 == corners.size ? 0 : i + 1;
    if (heights[i] <= 0)
      kept.add(corners.x[i], corners.y[i]);
    if ((heights[i] < 0 && heights[next] > 0) ||
        (heights[i] > 0 && heights[next] < 0)) {
      const double fall = heights[i] - heights[next];
      kept.add(corners.x[i] + (corners.x[next] - corners.x[i]) * heights[i] / fall,
               corners.y[i] + (corners.y[next] - corners.y[i]) * heights[i] / fall);
    }
  }
}

double
areaOf(const Polygon& corners)
{
  double twice = 0;
  for (std::size_t i = 2; i < corners.size; ++i)
    twice += (corners.x[i - 1] - corners.x[0]) * (corners.y[i] - corners.y[0]) -
             (corners.y[i - 1] - corners.y[0]) * (corners.x[i] - corners.x[0]);
  return twice / 2;
}

} // namespace

namespace pcl::indoor {

DirectionHulls::DirectionHulls()
{
  // In ascending order of length: the axes themselves come first, -x to +x.
  std::size_t next = 0;
  for (const int length : {1, 2, 3, 5})
    for (int x = -2; x <= 2; ++x)
      for (int y = -2; y <= 2; ++y)
        for (int z = -2; z <= 2; ++z)
          if (x * x + y * y + z * z == length)
            directions_[next++] = Eigen::Vector3d(x, y, z).normalized();
  for (std::size_t face = 0; face < count; ++face) {
    const Eigen::Vector3d normal = directions_[face], u = normal.unitOrthogonal(),
                          v = normal.cross(u);
    auto cut = cuts_[face].begin();
    for (std::size_t other = 0; other < count; ++other)
      if (other != face)
        *cut++ = {other,
                  u.dot(directions_[other]),
                  v.dot(directions_[other]),
                  normal.dot(directions_[other])};
    // Those that are likely to cut most first: hidden faces are soon known.
    std::stable_sort(cuts_[face].begin(),
                     cuts_[face].end(),
                     [](const auto& a, const auto& b) { return a.along > b.along; });
  }
}

KDop50
DirectionHulls::kDopOf(const std::vector<Eigen::Vector3f>& places, float margin) const
{
  return supportsOf<count>(places, margin, [this](std::size_t d) {
    const Eigen::Vector3f direction = directions_[d].cast<float>();
    return [direction](const Eigen::Vector3f& p) { return direction.dot(p); };
  });
}

double
DirectionHulls::volume(const KDop50& hull) const
{
  if (boxVolume(hull) <= 0)
    return 0;
  // Heights of the faces over the middle of the box, and a radius around all of it
  const Eigen::Vector3d high(hull[5], hull[4], hull[3]),
      low(-hull[0], -hull[1], -hull[2]);
  const Eigen::Vector3d middle = (low + high) / 2;
  std::array<double, count> heights;
  for (std::size_t face = 0; face < count; ++face)
    heights[face] = hull[face] - directions_[face].dot(middle);
  double volume = 0; // of the pyramids from the middle to the faces
  for (std::size_t face = 0; face < count; ++face)
    volume += heights[face] * faceArea(heights, face, (high - low).norm()) / 3;
  return volume;
}

double
DirectionHulls::boxVolume(const KDop50& hull) const
{
  double volume = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
    volume *= std::max(0.0, static_cast<double>(hull[axis]) + hull[5 - axis]);
  return volume;
}

double
DirectionHulls::faceArea(const std::array<double, count>& heights,
                         std::size_t face,
                         double radius) const
{
  Polygon one, other;
  Polygon *corners = &one, *kept = &other;
  one.add(-radius, -radius); // counter-clockwise
  one.add(radius, -radius);
  one.add(radius, radius);
  one.add(-radius, radius);
  Heights above;
  for (const auto& cut : cuts_[face]) {
    const double line = heights[cut.face] - heights[face] * cut.along;
    double highest = 0;
    for (std::size_t i = 0; i < corners->size; ++i) {
      above[i] = cut.u * corners->x[i] + cut.v * corners->y[i] - line;
      highest = std::max(highest, above[i]);
    }
    if (!(highest > 0))
      continue;
    clip(*corners, above, *kept);
    std::swap(corners, kept);
    if (corners->size < 3)
      return 0;
  }
  return areaOf(*corners);
}

} // namespace pcl::indoor
