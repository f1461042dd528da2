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

// Furniture that stands where the sensor's carrier would walk.
std::vector<const ObjectInfo*>
obstaclesIn(const Building& building, std::uint32_t room_number, double height)
{
  const double floor = building.rooms[room_number - 1].floor;
  std::vector<const ObjectInfo*> obstacles;
  for (const auto& object : building.objects) {
    const double low = object.position.z() - floor, high = low + object.size.z();
    const bool in_wall = object.category == "door" || object.category == "window";
    if (object.room == room_number && !in_wall && low < height + 0.2 && high > 0.1)
      obstacles.push_back(&object);
  }
  return obstacles;
}

std::vector<Candidate>
candidatesIn(const Building& building, std::uint32_t room_number, double height)
{
  constexpr double step = 0.2; // metres
  const auto& polygon = building.rooms[room_number - 1].polygon;
  const auto obstacles = obstaclesIn(building, room_number, height);
  Eigen::AlignedBox2d box;
  for (const auto& p : polygon)
    box.extend(p);
  std::vector<Candidate> candidates;
  for (double x = box.min().x() + step / 2; x < box.max().x(); x += step)
    for (double y = box.min().y() + step / 2; y < box.max().y(); y += step) {
      const Eigen::Vector2d at(x, y);
      if (!contains(polygon, at))
        continue;
      double free = distanceToBoundary(polygon, at);
      for (const auto* obstacle : obstacles)
        free = std::min(free, distanceToObject(*obstacle, at));
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
  for (std::uint32_t r = 1; r <= building.rooms.size(); ++r) {
    const auto& room = building.rooms[r - 1];
    const auto candidates = candidatesIn(building, r, options.sensor_height);
    for (const auto& at : spread(candidates, options.spacing, options.clearance)) {
      const double below_ceiling = room.ceiling.heightAt(at) - 0.2;
      positions.emplace_back(
          at.x(), at.y(), room.floor + std::min(options.sensor_height, below_ceiling));
    }
  }
  for (const auto& doorway : building.doorways)
    if (doorway.width > 2 * 0.35)
      positions.push_back(doorway.position +
                          Eigen::Vector3d(0, 0, options.sensor_height));
  return inWalkingOrder(std::move(positions));
}

} // namespace indoor
} // namespace pcl
