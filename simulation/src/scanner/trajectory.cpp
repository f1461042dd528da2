/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/trajectory.h>

#include "scanner/free_places.h"

#include <algorithm>

namespace pcl::indoor {

namespace {

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
         spread(placesOn(level, height), options.spacing, options.clearance))
      positions.push_back(level.sensorAt(at, height));
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

} // namespace pcl::indoor
