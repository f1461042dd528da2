/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/room_ways.h"

#include "export/shortest_paths.h"
#include "internal/cross.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl::indoor::tool {
namespace {

/** Does a line go through a side, from one of its sides to the other? */
bool
crosses(const Eigen::Vector2d& a,
        const Eigen::Vector2d& b,
        const Eigen::Vector2d& c,
        const Eigen::Vector2d& d)
{
  constexpr double touching = 1e-9; // m^2
  const double of_c = crossOf(b - a, c - a), of_d = crossOf(b - a, d - a);
  const double of_a = crossOf(d - c, a - c), of_b = crossOf(d - c, b - c);
  const auto apart = [](double one, double other) {
    return (one > touching && other < -touching) ||
           (one < -touching && other > touching);
  };
  return apart(of_c, of_d) && apart(of_a, of_b);
}

/** Corners that stick into the room, moved away from the walls. */
std::vector<Eigen::Vector2d>
turningPoints(const std::vector<PlanRing>& rings, double clearance)
{
  constexpr double least_turn = 0.17; // radians, 10 degrees
  std::vector<Eigen::Vector2d> points;
  for (const auto& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto& corner = ring[i];
      const Eigen::Vector2d in =
          (corner - ring[(i + ring.size() - 1) % ring.size()]).normalized();
      const Eigen::Vector2d out = (ring[(i + 1) % ring.size()] - corner).normalized();
      if (std::atan2(crossOf(in, out), in.dot(out)) > -least_turn)
        continue;
      const Eigen::Vector2d away = (in - out).normalized();
      for (double share = 1.0; share > 0.1; share *= 0.5) {
        const Eigen::Vector2d point = corner + share * clearance * away;
        if (isInside(rings, point) && seesEachOther(rings, corner, point)) {
          points.push_back(point);
          break;
        }
      }
    }
  return points;
}

} // namespace

bool
seesEachOther(const std::vector<PlanRing>& rings,
              const Eigen::Vector2d& a,
              const Eigen::Vector2d& b)
{
  for (const auto& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (crosses(a, b, ring[i], ring[(i + 1) % ring.size()]))
        return false;
  return isInside(rings, 0.5 * (a + b));
}

RoomWays
roomWays(const std::vector<PlanRing>& rings,
         const std::vector<Eigen::Vector2d>& places,
         double clearance)
{
  RoomWays ways;
  ways.points = places;
  const auto corners = turningPoints(rings, clearance);
  ways.points.insert(ways.points.end(), corners.begin(), corners.end());
  std::vector<WeightedLine> lines;
  for (std::size_t a = 0; a < ways.points.size(); ++a)
    for (std::size_t b = a + 1; b < ways.points.size(); ++b)
      if (seesEachOther(rings, ways.points[a], ways.points[b]))
        lines.push_back({a, b, (ways.points[a] - ways.points[b]).norm()});
  const ShortestPaths paths(ways.points.size(), lines);
  std::set<std::pair<std::size_t, std::size_t>> used;
  for (std::size_t a = 0; a < places.size(); ++a) {
    const auto from = paths.from(a);
    for (std::size_t b = a + 1; b < places.size(); ++b) {
      auto path = from.to(b);
      if (path.empty() && a == 0)
        path = {a, b};
      for (std::size_t i = 0; i + 1 < path.size(); ++i)
        used.insert(std::minmax(path[i], path[i + 1]));
    }
  }
  ways.lines.assign(used.begin(), used.end());
  return ways;
}

} // namespace pcl::indoor::tool
