/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/trajectory.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace indoor {

namespace {

struct Candidate {
  Eigen::Vector2d at;
  double free; // metres to the nearest wall or piece of furniture
};

double
distanceToObject(const ObjectInfo& object, const Eigen::Vector2d& at)
{
  const Eigen::Vector2d local =
      Eigen::Rotation2Dd(-object.rotation) * (at - object.position.head<2>());
  const Eigen::Vector2d beyond =
      (local.cwiseAbs() - object.size.head<2>() / 2).cwiseMax(0.0);
  return beyond.norm();
}

// What the sensor's carrier walks on: the floor of a room, or a platform in it.
struct Level {
  const Building& building;
  std::uint32_t room_number;
  const PlatformInfo* platform; // none: the floor

  const RoomInfo&
  room() const
  {
    return building.rooms[room_number - 1];
  }

  double
  heightAt(const Eigen::Vector2d& at) const
  {
    return platform ? platform->elevation + platform->top.heightAt(at) : room().floor;
  }

  double
  headroomAt(const Eigen::Vector2d& at) const
  {
    return room().floor + room().ceiling.heightAt(at) - heightAt(at);
  }
};

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

std::vector<Candidate>
candidatesOn(const Level& level, double height)
{
  constexpr double step = 0.2;     // metres
  constexpr double headroom = 1.8; // metres: nobody walks below
  const auto walls = level.room().polygonAt(level.room().floor + height);
  const auto& polygon = level.platform ? level.platform->polygon : walls;
  const auto obstacles = obstaclesOn(level, height);
  const auto gaps = gapsIn(level, height);
  Eigen::AlignedBox2d box;
  for (const auto& p : polygon)
    box.extend(p);
  std::vector<Candidate> candidates;
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
        candidates.push_back({at, free});
    }
  return candidates;
}

// The freest place first, then always the one farthest from all chosen ones.
std::vector<Eigen::Vector2d>
spread(const std::vector<Candidate>& candidates, double spacing, double clearance)
{
  std::vector<Eigen::Vector2d> chosen;
  if (candidates.empty())
    return chosen;
  const auto freest =
      std::max_element(candidates.begin(),
                       candidates.end(),
                       [](const auto& a, const auto& b) { return a.free < b.free; });
  chosen.push_back(freest->at);
  std::vector<double> distance(candidates.size(),
                               std::numeric_limits<double>::infinity());
  while (true) {
    std::size_t farthest = candidates.size();
    double most = spacing;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      distance[i] = std::min(distance[i], (candidates[i].at - chosen.back()).norm());
      if (candidates[i].free >= clearance && distance[i] > most) {
        most = distance[i];
        farthest = i;
      }
    }
    if (farthest == candidates.size())
      return chosen;
    chosen.push_back(candidates[farthest].at);
  }
}

// A walk from the first position, always to the nearest one that is left.
std::vector<Eigen::Vector3d>
inWalkingOrder(std::vector<Eigen::Vector3d> left)
{
  constexpr double climb = 100.0; // a metre up weighs as much as this many along
  std::vector<Eigen::Vector3d> walk;
  Eigen::Vector3d here = left.empty() ? Eigen::Vector3d::Zero() : left.front();
  while (!left.empty()) {
    const auto nearest =
        std::min_element(left.begin(), left.end(), [&](const auto& a, const auto& b) {
          const Eigen::Vector3d weight(1.0, 1.0, climb);
          return (a - here).cwiseProduct(weight).squaredNorm() <
                 (b - here).cwiseProduct(weight).squaredNorm();
        });
    here = *nearest;
    left.erase(nearest);
    walk.push_back(here);
  }
  return walk;
}

} // namespace

std::vector<Eigen::Vector3d>
planTrajectory(const Building& building, const TrajectoryOptions& options)
{
  if (!(options.spacing > 0) || !(options.sensor_height > 0) ||
      !(options.clearance >= 0))
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "spacing and sensor height must be positive and the clearance "
                        "not negative, not "
                            << options.spacing << ", " << options.sensor_height
                            << " and " << options.clearance << " m");
  std::vector<Eigen::Vector3d> positions;
  const auto addLevel = [&](const Level& level) {
    const double height = options.sensor_height;
    for (const auto& at :
         spread(candidatesOn(level, height), options.spacing, options.clearance)) {
      const double below_ceiling = level.headroomAt(at) - 0.2;
      positions.push_back(building.leant(
          {at.x(), at.y(), level.heightAt(at) + std::min(height, below_ceiling)}));
    }
  };
  for (std::uint32_t r = 1; r <= building.rooms.size(); ++r)
    addLevel({building, r, nullptr});
  for (const auto& platform : building.platforms)
    addLevel({building, platform.room, &platform});
  for (const auto& doorway : building.doorways)
    if (doorway.width > 2 * 0.35) {
      Eigen::Vector3d up(0, 0, options.sensor_height);
      up.head<2>() = options.sensor_height * doorway.drift;
      positions.push_back(doorway.position + up);
    }
  return inWalkingOrder(std::move(positions));
}

} // namespace indoor
} // namespace pcl
