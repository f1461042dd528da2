/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/plan_polygon.h"

#include "internal/cross.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace pcl::indoor::tool {
namespace {

constexpr double least_area = 1e-4; // m^2, of a piece or a hole

/** A square of places, in the order of how wide it may be around one of them. */
struct Square {
  double most = 0.0; ///< distance from the sides of any place in it, at most
  double width = 0.0;
  Eigen::Vector2d center;

  bool
  operator<(const Square& other) const
  {
    return std::make_tuple(most, -center.x(), -center.y()) <
           std::make_tuple(other.most, -other.center.x(), -other.center.y());
  }
};

/** Negative outside. */
double
depthOf(const std::vector<PlanRing>& rings, const Eigen::Vector2d& place)
{
  const double distance = distanceToSides(rings, place);
  return isInside(rings, place) ? distance : -distance;
}

} // namespace

double
signedArea(const PlanRing& ring)
{
  double area = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    area += 0.5 * crossOf(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  return area;
}

double
perimeter(const PlanRing& ring)
{
  double length = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    length += (ring[(i + 1) % ring.size()] - ring[i]).norm();
  return length;
}

std::vector<PlanPolygon>
polygonsOf(const std::vector<PlanRing>& rings)
{
  std::vector<PlanPolygon> polygons;
  for (const auto& ring : rings)
    if (signedArea(ring) > least_area)
      polygons.push_back({ring, {}});
  for (const auto& ring : rings)
    if (signedArea(ring) < -least_area)
      for (auto& polygon : polygons)
        if (isInside({polygon.outer}, ring[0])) {
          polygon.holes.push_back(ring);
          break;
        }
  return polygons;
}

bool
isInside(const std::vector<PlanRing>& rings, const Eigen::Vector2d& place)
{
  bool inside = false; // an odd number of sides lies to the right
  forEachSideAcross(rings, place.y(), [&](const auto& a, const auto& b) {
    if (place.x() < xOfSide(a, b, place.y()))
      inside = !inside;
  });
  return inside;
}

double
distanceToLine(const Eigen::Vector2d& begin,
               const Eigen::Vector2d& end,
               const Eigen::Vector2d& place)
{
  const Eigen::Vector2d way = end - begin;
  const double squared = way.squaredNorm();
  const double share =
      squared > 0.0 ? std::clamp((place - begin).dot(way) / squared, 0.0, 1.0) : 0.0;
  return (begin + share * way - place).norm();
}

PlanRing
bandAround(const Eigen::Vector2d& begin,
           const Eigen::Vector2d& end,
           double left,
           double right)
{
  const Eigen::Vector2d way = (end - begin).normalized();
  const Eigen::Vector2d across(-way.y(), way.x());
  return {begin - right * across,
          end - right * across,
          end + left * across,
          begin + left * across};
}

double
distanceToSides(const std::vector<PlanRing>& rings, const Eigen::Vector2d& place)
{
  double distance = std::numeric_limits<double>::infinity();
  for (const auto& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      distance = std::min(distance,
                          distanceToLine(ring[i], ring[(i + 1) % ring.size()], place));
  return distance;
}

Eigen::Vector2d
directionOfSides(const std::vector<PlanRing>& rings,
                 const Eigen::Vector2d& middle,
                 double width)
{
  constexpr double about = 0.3; // metres
  const double nearest = distanceToSides(rings, middle);
  double longest = 0.0;
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();
  for (const auto& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto& begin = ring[i];
      const auto& end = ring[(i + 1) % ring.size()];
      const double length = std::min((end - begin).norm(), 2.0 * width);
      if (length > longest && distanceToLine(begin, end, middle) <= nearest + about) {
        longest = length;
        along = (end - begin).normalized();
      }
    }
  return along;
}

Eigen::Vector2d
widestPlace(const std::vector<PlanRing>& rings)
{
  constexpr double precision = 0.02;  // metres
  constexpr std::size_t most = 20000; // squares: long spikes end, too
  Eigen::AlignedBox2d box;
  for (const auto& ring : rings)
    for (const auto& corner : ring)
      box.extend(corner);
  if (box.isEmpty())
    return Eigen::Vector2d::Zero();
  Eigen::Vector2d best = rings[0][0];
  double depth = 0.0;
  std::priority_queue<Square> squares;
  const auto look = [&](const Eigen::Vector2d& center, double width) {
    const double here = depthOf(rings, center);
    if (here > depth) {
      depth = here;
      best = center;
    }
    if (here + width * M_SQRT1_2 > depth + precision)
      squares.push({here + width * M_SQRT1_2, width, center});
  };
  look(box.center(), box.sizes().maxCoeff());
  for (std::size_t i = 0;
       i < most && !squares.empty() && squares.top().most > depth + precision;
       ++i) {
    const auto square = squares.top();
    squares.pop();
    for (const double x : {-0.25, 0.25})
      for (const double y : {-0.25, 0.25})
        look(square.center + square.width * Eigen::Vector2d(x, y), 0.5 * square.width);
  }
  return best;
}

} // namespace pcl::indoor::tool
