/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "random/resting_places.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

std::vector<Triangle>
trianglesOf(const FurnitureModel& model)
{
  std::vector<Triangle> triangles;
  for (const auto& part : model.parts)
    triangles.insert(triangles.end(), part.triangles.begin(), part.triangles.end());
  return triangles;
}

// Nine places of a footprint, those at its rim a little inside.
std::vector<Eigen::Vector2d>
probes(const Polygon& footprint)
{
  constexpr double share = 0.85; // of the way to its rim
  const Eigen::Vector2d middle = (footprint[0] + footprint[2]) / 2,
                        right = share * (footprint[1] - footprint[0]) / 2,
                        up = share * (footprint[3] - footprint[0]) / 2;
  std::vector<Eigen::Vector2d> places{middle};
  for (const double u : {-1.0, 0.0, 1.0})
    for (const double v : {-1.0, 0.0, 1.0})
      if (u != 0 || v != 0)
        places.push_back(middle + u * right + v * up);
  return places;
}

Eigen::Vector3f
above(const Eigen::Vector2d& place, double z)
{
  return Eigen::Vector3d(place.x(), place.y(), z).cast<float>();
}

} // namespace

RestingPlaces::RestingPlaces(const FurnitureModel& model)
: top_(model.size.z())
, tracer_(trianglesOf(model))
{
  constexpr float upright = 0.9f; // least cosine with the vertical of what carries
  for (const auto& t : trianglesOf(model)) {
    const Eigen::Vector3f normal = (t.b - t.a).cross(t.c - t.a);
    is_level_.push_back(normal.z() > upright * normal.norm());
  }
}

std::vector<double>
RestingPlaces::levels(const Polygon& footprint, double height, double give) const
{
  const auto places = probes(footprint);
  const Eigen::Vector3f down(0, 0, -1);
  std::vector<double> found;
  for (double from = top_ + height + 0.1; from > 0;) {
    const auto hit = tracer_.trace(above(places[0], from), down);
    if (hit.triangle < 0)
      break;
    const double level = from - hit.distance;
    from = level - 0.005;
    if (!is_level_[static_cast<std::size_t>(hit.triangle)])
      continue;
    double sum = 0;
    const bool carries =
        std::all_of(places.begin(), places.end(), [&](const auto& place) {
          const auto below = tracer_.trace(above(place, level + height), down);
          sum += level + height - below.distance;
          return std::abs(height - below.distance) <= give;
        });
    if (carries)
      found.push_back(sum / static_cast<double>(places.size()));
  }
  std::reverse(found.begin(), found.end());
  return found;
}

bool
RestingPlaces::isFreeBelow(const Polygon& footprint, double height) const
{
  const auto places = probes(footprint);
  return std::all_of(places.begin(), places.end(), [&](const auto& place) {
    return tracer_.trace(above(place, 0.001), {0, 0, 1}).distance > height;
  });
}

} // namespace pcl::indoor
