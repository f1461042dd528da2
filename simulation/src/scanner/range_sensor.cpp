/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/range_sensor.h>

#include "scanner/option_check.h"
#include "scanner/ray_echo.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace pcl::indoor {

namespace {

// The i-th of n directions, spread evenly over the sphere along a spiral.
Eigen::Vector3d
spiralDirection(int i, int n, double turn, double shift)
{
  static const double golden_angle = M_PI * (3.0 - std::sqrt(5.0));
  const double z = 1.0 - 2.0 * (i + shift) / n;
  const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
  const double angle = turn + golden_angle * i;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

std::vector<PointXYZScene>
scanFrom(const RayScene& scene,
         const Eigen::Vector3d& position,
         const RangeSensorOptions& options,
         RandomDraw draw)
{
  const double turn = draw.uniform(0.0, 2 * M_PI), shift = draw.uniform();
  Eigen::Vector3d error;
  for (const int k : {2, 1, 0})
    error[k] = draw.gaussian();
  error.z() *= 0.5;
  error *= options.drift;
  const double heading_error = draw.gaussian() * options.drift / typical_range;
  const Eigen::Matrix3d heading =
      Eigen::AngleAxisd(heading_error, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Vector3f origin = position.cast<float>();
  const auto reach = static_cast<float>(options.max_range);
  std::vector<PointXYZScene> points;
  for (int i = 0; i < options.rays_per_pose; ++i) {
    const auto direction = spiralDirection(i, options.rays_per_pose, turn, shift);
    const Echo echo =
        followBeam(scene, origin, direction.cast<float>(), reach, options, draw);
    if (echo.triangle < 0)
      continue;
    const double range = echo.range + options.noise * draw.gaussian();
    const Eigen::Vector3d at = position + error + heading * (range * direction);
    points.push_back(labelledPoint(scene, echo, at));
  }
  return points;
}

} // namespace

SimulatedScan
scanBuilding(const Building& building,
             const std::vector<Eigen::Vector3d>& positions,
             const RangeSensorOptions& options)
{
  requireOption(
      options.rays_per_pose >= 1, "rays_per_pose", options.rays_per_pose, "at least 1");
  requireOption(options.drift >= 0, "drift", options.drift, "at least 0 m");
  requireLegal(options);
  const RayScene scene(building);
  return scanFromPoses(positions.size(),
                       static_cast<std::size_t>(options.rays_per_pose),
                       options,
                       [&](std::size_t pose, const RandomDraw& draw) {
                         return scanFrom(scene, positions[pose], options, draw);
                       });
}

void
thinScan(SimulatedScan& scan, double leaf_size)
{
  constexpr double smallest = 0.001; // metres: the grid's 21 bits per axis span 2 km
  if (leaf_size != 0 && !(leaf_size >= smallest))
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "the leaf size must be 0 or at least 0.001 m, not " << leaf_size
                                                                            << " m");
  if (leaf_size == 0 || scan.points.empty())
    return;
  std::unordered_set<std::uint64_t> taken;
  taken.reserve(scan.points.size() / 2);
  const auto indexOf = [&](float coordinate) {
    return static_cast<std::int64_t>(std::floor(coordinate / leaf_size));
  };
  const PointXYZScene first = scan.points.front();
  const auto cell = [&](float coordinate, float reference) {
    const auto offset = indexOf(coordinate) - indexOf(reference) + (1 << 20);
    return static_cast<std::uint64_t>(offset) & 0x1FFFFFu;
  };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const auto& p = scan.points[i];
    const auto key =
        cell(p.x, first.x) << 42 | cell(p.y, first.y) << 21 | cell(p.z, first.z);
    if (!taken.insert(key).second)
      continue;
    scan.points[kept] = scan.points[i];
    scan.poses[kept++] = scan.poses[i];
  }
  scan.points.resize(kept);
  scan.poses.resize(kept);
}

} // namespace pcl::indoor
