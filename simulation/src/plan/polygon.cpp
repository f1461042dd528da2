/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/polygon.h>

#include "internal/cross.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace pcl::indoor {

namespace {

double
turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  return crossOf(b - a, c - a);
}

// Strictly: the segments cross in a point inside both.
bool
properlyCross(const Eigen::Vector2d& a,
              const Eigen::Vector2d& b,
              const Eigen::Vector2d& c,
              const Eigen::Vector2d& d)
{
  constexpr double tolerance = 1e-9;
  const double c_side = turn(a, b, c), d_side = turn(a, b, d);
  const double a_side = turn(c, d, a), b_side = turn(c, d, b);
  return std::min(c_side, d_side) < -tolerance &&
         std::max(c_side, d_side) > tolerance &&
         std::min(a_side, b_side) < -tolerance && std::max(a_side, b_side) > tolerance;
}

// What of a convex polygon lies on a side of a line; few corners enclose nothing.
// side_of(corner): how far it is on that side; negative on the other.
template <typename SideOf>
Polygon
partOnSide(const Polygon& convex, const SideOf& side_of)
{
  Polygon kept;
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const auto& p = convex[i];
    const auto& q = convex[(i + 1) % convex.size()];
    const double p_side = side_of(p), q_side = side_of(q);
    if (p_side >= 0)
      kept.push_back(p);
    if ((p_side > 0 && q_side < 0) || (p_side < 0 && q_side > 0))
      kept.push_back(p + (q - p) * (p_side / (p_side - q_side)));
  }
  return kept;
}

// Of two counter-clockwise triangles: cut the first along each edge of the second.
double
commonArea(Polygon piece, const Polygon& cutter)
{
  for (std::size_t e = 0; e < cutter.size() && !piece.empty(); ++e) {
    const auto& a = cutter[e];
    const auto& b = cutter[(e + 1) % cutter.size()];
    piece = partOnSide(piece, [&](const auto& corner) { return turn(a, b, corner); });
  }
  return piece.empty() ? 0.0 : signedArea(piece);
}

bool
insideTriangle(const Eigen::Vector2d& p,
               const Eigen::Vector2d& a,
               const Eigen::Vector2d& b,
               const Eigen::Vector2d& c)
{
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

bool
isEar(const Polygon& polygon, const std::vector<int>& left, std::size_t i)
{
  const std::size_t n = left.size();
  const auto& a = polygon[left[(i + n - 1) % n]];
  const auto& b = polygon[left[i]];
  const auto& c = polygon[left[(i + 1) % n]];
  if (turn(a, b, c) <= 1e-12)
    return false;
  return std::none_of(left.begin(), left.end(), [&](int v) {
    const auto& p = polygon[v];
    return p != a && p != b && p != c && insideTriangle(p, a, b, c);
  });
}

} // namespace

double
signedArea(const Polygon& polygon)
{
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += crossOf(polygon[i], polygon[(i + 1) % polygon.size()]);
  return twice / 2;
}

bool
contains(const Polygon& polygon, const Eigen::Vector2d& point)
{
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const auto& a = polygon[i];
    const auto& b = polygon[j];
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x())
      inside = !inside;
  }
  return inside;
}

double
distanceToSegment(const Eigen::Vector2d& point,
                  const Eigen::Vector2d& a,
                  const Eigen::Vector2d& b)
{
  const Eigen::Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  const double t =
      length2 > 0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (a + t * along - point).norm();
}

double
distanceToBoundary(const Polygon& polygon, const Eigen::Vector2d& point)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    nearest = std::min(
        nearest,
        distanceToSegment(point, polygon[i], polygon[(i + 1) % polygon.size()]));
  return nearest;
}

bool
crossesItself(const Polygon& polygon)
{
  constexpr double touching = 1e-6; // metres
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto& a = polygon[i];
    const auto& b = polygon[(i + 1) % n];
    if ((b - a).norm() < touching)
      return true;
    for (std::size_t j = i + 1; j < n; ++j) {
      const auto& c = polygon[j];
      const auto& d = polygon[(j + 1) % n];
      if (j == i + 1 || (j + 1) % n == i) { // neighbours: no fold back onto itself
        const auto& shared = j == i + 1 ? b : a;
        const auto& first = j == i + 1 ? a : b;
        const auto& other = j == i + 1 ? d : c;
        if (distanceToSegment(first, shared, other) < touching ||
            distanceToSegment(other, shared, first) < touching)
          return true;
      }
      else if (properlyCross(a, b, c, d) || distanceToSegment(a, c, d) < touching ||
               distanceToSegment(c, a, b) < touching)
        return true;
    }
  }
  return false;
}

bool
overlap(const Polygon& a, const Polygon& b)
{
  constexpr double smallest = 1e-6; // square metres: rounding along a common wall
  double common = 0;
  for (const auto& s : triangulate(a))
    for (const auto& t : triangulate(b))
      common += commonArea({a[s[0]], a[s[1]], a[s[2]]}, {b[t[0]], b[t[1]], b[t[2]]});
  return common > smallest;
}

Polygon
inset(const Polygon& polygon, double distance)
{
  const std::size_t n = polygon.size();
  Polygon result(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d before = (polygon[i] - polygon[(i + n - 1) % n]).normalized();
    const Eigen::Vector2d after = (polygon[(i + 1) % n] - polygon[i]).normalized();
    const Eigen::Vector2d normal_before(-before.y(), before.x());
    const Eigen::Vector2d normal_after(-after.y(), after.x());
    // The corner of both moved lines lies on the bisector of their normals.
    const Eigen::Vector2d sum = normal_before + normal_after;
    result[i] = polygon[i] + sum * (distance / (1.0 + normal_before.dot(normal_after)));
  }
  return result;
}

HalfPlane
leftOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  const Eigen::Vector2d right(b.y() - a.y(), a.x() - b.x());
  return {right, right.dot(a)};
}

Polygon
clip(const Polygon& convex, const HalfPlane& half_plane)
{
  auto kept = partOnSide(convex, [&](const auto& corner) {
    return half_plane.offset - half_plane.normal.dot(corner);
  });
  return kept.size() < 3 ? Polygon() : kept;
}

std::vector<Polygon>
subtract(const Polygon& convex, const Polygon& hole)
{
  std::vector<Polygon> pieces;
  Polygon left = convex;
  for (std::size_t i = 0; i < hole.size() && !left.empty(); ++i) {
    const auto& a = hole[i];
    const auto& b = hole[(i + 1) % hole.size()];
    const auto outside = clip(left, leftOf(b, a));
    if (!outside.empty())
      pieces.push_back(outside);
    left = clip(left, leftOf(a, b));
  }
  return left.empty() ? std::vector<Polygon>{convex} : pieces;
}

bool
isConvex(const Polygon& polygon)
{
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
    if (turn(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) < -1e-9)
      return false;
  return true;
}

std::vector<std::array<int, 3>>
triangulate(const Polygon& polygon)
{
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> left(polygon.size());
  std::iota(left.begin(), left.end(), 0);
  while (left.size() > 2) {
    const std::size_t n = left.size();
    std::size_t ear = 0;
    while (ear < n && !isEar(polygon, left, ear))
      ++ear;
    if (ear == n) // only vertices on a straight line are left: drop one
      ear = 0;
    triangles.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return triangles;
}

} // namespace pcl::indoor
