/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/opening_place.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

std::vector<PlanRing>
ringsBeside(const SavedScene& scene, const SavedOpening& opening)
{
  std::vector<PlanRing> rings;
  for (const auto number : {opening.room_a, opening.room_b})
    if (number > 0) {
      const auto& more = scene.rooms[number - 1].rings;
      rings.insert(rings.end(), more.begin(), more.end());
    }
  return rings;
}

/** From a place to the inside of rings; at least the given metres. */
double
reach(const std::vector<PlanRing>& rings,
      const Eigen::Vector2d& from,
      const Eigen::Vector2d& way,
      double least)
{
  constexpr int steps = 100; // of a centimetre
  for (int i = 0; i <= steps; ++i)
    if (isInside(rings, from + 0.01 * i * way))
      return std::max(least, 0.01 * i);
  return least;
}

} // namespace

OpeningPlace
openingPlace(const SavedScene& scene, const SavedOpening& opening)
{
  OpeningPlace place;
  place.middle = opening.position.head<2>();
  const auto rings = ringsBeside(scene, opening);
  place.along = directionOfSides(rings, place.middle, opening.width);
  double least = 0.0;
  if (opening.wall < scene.walls.size()) {
    const auto& wall = scene.walls[opening.wall];
    const Eigen::Vector2d way = wall.end - wall.begin;
    if (way.norm() > 0.0)
      place.along = way.normalized();
    least = 0.5 * wall.thickness;
  }
  const Eigen::Vector2d left(-place.along.y(), place.along.x());
  place.left = reach(rings, place.middle, left, least);
  place.right = reach(rings, place.middle, -left, least);
  return place;
}

} // namespace pcl::indoor::tool
