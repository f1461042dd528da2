/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scanner/ray_echo.h"

#include "scanner/option_check.h"

#include <pcl/indoor/parallel_for.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <mutex>

namespace pcl::indoor {

namespace {

// Follow one ray through panes of glass to the surface that returns it.
Echo
follow(const RayScene& scene,
       Eigen::Vector3f origin,
       Eigen::Vector3f direction,
       float reach,
       const EchoOptions& options,
       RandomDraw& draw)
{
  constexpr int most_panes = 8;
  constexpr float off_pane = 1e-4f; // metres: do not meet the same pane again
  Echo echo;
  float start = static_cast<float>(options.min_range);
  for (int pane = 0; pane <= most_panes; ++pane) {
    const RayHit hit = scene.tracer.trace(origin, direction, start, reach - echo.range);
    if (hit.triangle < 0)
      return {0.0f, -1, echo.mirrored, true};
    echo.range += hit.distance;
    const auto& surface = scene.building.surfaces[hit.triangle];
    const Eigen::Vector3f& normal = scene.normals[hit.triangle];
    const float cosine = normal.dot(direction);
    if (surface.kind == SurfaceKind::Shell && cosine > 0)
      return {};
    if (!surface.isGlass()) {
      echo.triangle = hit.triangle;
      return draw.uniform() < echoProbability(cosine, options) ? echo : Echo();
    }
    const double fate = draw.uniform();
    if (fate < options.glass_echo) {
      echo.triangle = hit.triangle;
      return echo;
    }
    origin += hit.distance * direction;
    if (fate < options.glass_echo + options.glass_ghost) {
      direction -= 2.0f * cosine * normal;
      echo.mirrored = true;
    }
    else if (surface.kind == SurfaceKind::ExteriorGlass)
      return {};
    start = off_pane;
  }
  return {};
}

} // namespace

RayScene::RayScene(const Building& scanned)
: building(scanned)
, tracer(scanned.triangles)
, ghost(scanned.category("ghost"))
{
  for (const auto& t : building.triangles)
    normals.push_back((t.b - t.a).cross(t.c - t.a).normalized());
}

void
requireLegal(const EchoOptions& o)
{
  const auto isShare = [](double share) { return share >= 0 && share <= 1; };
  requireOption(o.min_range >= 0, "min_range", o.min_range, "at least 0 m");
  requireOption(o.max_range > o.min_range, "max_range", o.max_range, "above min_range");
  requireOption(o.noise >= 0, "noise", o.noise, "at least 0 m");
  requireOption(o.beam >= 0 && o.beam <= 0.1, "beam", o.beam, "from 0 to 0.1 radians");
  requireOption(isShare(o.dropout), "dropout", o.dropout, "from 0 to 1");
  requireOption(
      o.grazing_exponent > 0, "grazing_exponent", o.grazing_exponent, "positive");
  requireOption(isShare(o.glass_echo), "glass_echo", o.glass_echo, "from 0 to 1");
  requireOption(isShare(o.glass_ghost) && o.glass_echo + o.glass_ghost <= 1,
                "glass_ghost",
                o.glass_ghost,
                "from 0 to 1 - glass_echo");
  requireOption(o.threads >= 0, "threads", o.threads, "at least 0");
}

double
echoProbability(double cosine, const EchoOptions& options)
{
  const double grazing = 1.0 - std::min(1.0, std::abs(cosine));
  return (1.0 - options.dropout) * (1.0 - std::pow(grazing, options.grazing_exponent));
}

Echo
followBeam(const RayScene& scene,
           const Eigen::Vector3f& origin,
           const Eigen::Vector3f& direction,
           float reach,
           const EchoOptions& options,
           RandomDraw& draw)
{
  constexpr float longest_pulse = 0.5f; // metres: echoes farther apart are told apart
  reach = std::min(reach, static_cast<float>(options.max_range));
  Echo echo = follow(scene, origin, direction, reach, options, draw);
  if (options.beam == 0 || echo.triangle < 0 || echo.mirrored)
    return echo;
  Eigen::Vector3d beside = direction.cast<double>();
  for (int k = 0; k < 3; ++k)
    beside[k] += options.beam * draw.gaussian();
  const float share = static_cast<float>(draw.uniform(0, 0.5));
  const Echo other =
      follow(scene, origin, beside.normalized().cast<float>(), reach, options, draw);
  if (other.triangle >= 0 && !other.mirrored &&
      std::abs(other.range - echo.range) < longest_pulse)
    echo.range += share * (other.range - echo.range);
  return echo;
}

void
place(PointXYZScene& point, const Eigen::Vector3d& at)
{
  point.x = static_cast<float>(at.x());
  point.y = static_cast<float>(at.y());
  point.z = static_cast<float>(at.z());
}

PointXYZScene
labelledPoint(const RayScene& scene, const Echo& echo, const Eigen::Vector3d& at)
{
  PointXYZScene point;
  place(point, at);
  if (echo.mirrored) {
    point.category = scene.ghost;
    return point;
  }
  const auto& labels = scene.building.surfaces[echo.triangle].labels;
  point.room = labels.room;
  point.object = labels.object;
  point.part = labels.part;
  point.category = labels.category;
  return point;
}

SimulatedScan
scanFromPoses(std::size_t poses,
              std::size_t rays_per_pose,
              const EchoOptions& options,
              const PoseScan& scan_from)
{
  std::vector<std::vector<PointXYZScene>> per_pose(poses);
  std::size_t done = 0;
  std::mutex mutex; // of the number and of who is told it
  const auto pose_count = static_cast<std::ptrdiff_t>(poses);
  parallelFor(pose_count, options.threads, 1, [&](std::ptrdiff_t i) {
    const auto pose = static_cast<std::uint32_t>(i);
    per_pose[i] = scan_from(pose, RandomDraw(mixSeed(options.seed, pose)));
    const std::lock_guard<std::mutex> lock(mutex);
    ++done;
    if (options.progress)
      options.progress(done, poses);
  });
  SimulatedScan scan;
  scan.ray_count = poses * rays_per_pose;
  for (std::size_t i = 0; i < poses; ++i) {
    scan.points.insert(scan.points.end(), per_pose[i].begin(), per_pose[i].end());
    scan.poses.resize(scan.points.size(), static_cast<std::uint32_t>(i));
    std::vector<PointXYZScene>().swap(per_pose[i]); // large scans fill the memory
  }
  return scan;
}

} // namespace pcl::indoor
