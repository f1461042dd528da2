/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scanner/free_places.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::indoor {

namespace {

double
distanceToObject(const ObjectInfo& object, const Eigen::Vector2d& at)
{
  const Eigen::Vector2d local =
      Eigen::Rotation2Dd(-object.rotation) * (at - object.position.head<2>());
  const Eigen::Vector2d beyond =
      (local.cwiseAbs() - object.size.head<2>() / 2).cwiseMax(0.0);
  return beyond.norm();
}

// Holes in the level, and platforms in the way of somebody of this height.
std::vector<const Polygon*>
gapsIn(const Level& level, double height)
{
  std::vector<const Polygon*> gaps;
  for (const auto& well : level.building.wells)
    if (well.upper == level.room_number && !level.platform)
      gaps.push_back(&well.polygon);
  for (const auto& other : level.building.platforms) {
    if (other.room != level.room_number || &other == level.platform)
      continue;
    const auto blocks = [&](const Eigen::Vector2d& p) {
      const double top = other.elevation + other.top.heightAt(p);
      const double bottom =
          other.thickness ? top - *other.thickness : level.room().floor;
      const double here = level.heightAt(p);
      return bottom < here + height + 0.2 && top > here + 0.1;
    };
    if (std::any_of(other.polygon.begin(), other.polygon.end(), blocks))
      gaps.push_back(&other.polygon);
  }
  return gaps;
}

// Furniture that stands where the sensor's carrier would walk.
std::vector<const ObjectInfo*>
obstaclesOn(const Level& level, double height)
{
  std::vector<const ObjectInfo*> obstacles;
  for (const auto& object : level.building.objects) {
    const Eigen::Vector2d at =
        object.position.head<2>() - object.position.z() * level.building.lean;
    const double floor = level.heightAt(at);
    const double low = object.position.z() - floor, high = low + object.size.z();
    const bool in_wall = object.category == "door" || object.category == "window";
    if (object.stands_in == level.room_number && !in_wall && low < height + 0.2 &&
        high > 0.1)
      obstacles.push_back(&object);
  }
  return obstacles;
}

} // namespace

Eigen::Vector3d
Level::sensorAt(const Eigen::Vector2d& at, double height) const
{
  const double below_ceiling = headroomAt(at) - 0.2;
  return building.leant(
      {at.x(), at.y(), heightAt(at) + std::min(height, below_ceiling)});
}

std::vector<FreePlace>
placesOn(const Level& level, double height)
{
  constexpr double step = place_step;
  constexpr double headroom = 1.8; // metres: nobody walks below
  const auto walls = level.room().polygonAt(level.room().floor + height);
  const auto& polygon = level.platform ? level.platform->polygon : walls;
  const auto obstacles = obstaclesOn(level, height);
  const auto gaps = gapsIn(level, height);
  Eigen::AlignedBox2d box;
  for (const auto& p : polygon)
    box.extend(p);
  std::vector<FreePlace> places;
  for (double x = box.min().x() + step / 2; x < box.max().x(); x += step)
    for (double y = box.min().y() + step / 2; y < box.max().y(); y += step) {
      const Eigen::Vector2d at(x, y);
      const auto inGap = [&](const Polygon* gap) { return contains(*gap, at); };
      if (!contains(polygon, at) || level.headroomAt(at) < headroom ||
          std::any_of(gaps.begin(), gaps.end(), inGap))
        continue;
      double free = distanceToBoundary(polygon, at);
      const Eigen::Vector2d leant =
          at + (level.heightAt(at) + height) * level.building.lean;
      for (const auto* obstacle : obstacles)
        free = std::min(free, distanceToObject(*obstacle, leant));
      for (const auto* gap : gaps)
        free = std::min(free, distanceToBoundary(*gap, at));
      if (free > 0)
        places.push_back({at, free});
    }
  return places;
}

std::vector<Eigen::Vector2d>
spread(const std::vector<FreePlace>& places, double spacing, double clearance)
{
  std::vector<Eigen::Vector2d> chosen;
  if (places.empty())
    return chosen;
  const auto freest =
      std::max_element(places.begin(), places.end(), [](const auto& a, const auto& b) {
        return a.free < b.free;
      });
  chosen.push_back(freest->at);
  std::vector<double> distance(places.size(), std::numeric_limits<double>::infinity());
  while (true) {
    std::size_t farthest = places.size();
    double most = spacing;
    for (std::size_t i = 0; i < places.size(); ++i) {
      distance[i] = std::min(distance[i], (places[i].at - chosen.back()).norm());
      if (places[i].free >= clearance && distance[i] > most) {
        most = distance[i];
        farthest = i;
      }
    }
    if (farthest == places.size())
      return chosen;
    chosen.push_back(places[farthest].at);
  }
}

} // namespace pcl::indoor
