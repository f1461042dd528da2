/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/range_sensor.h>

#include "scanner/option_check.h"

#include <pcl/simulation/random_draw.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <exception>
#include <unordered_set>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace pcl {
namespace indoor {

namespace {

void
requireLegal(const RangeSensorOptions& o)
{
  const auto isShare = [](double share) { return share >= 0 && share <= 1; };
  requireOption(o.rays_per_pose >= 1, "rays_per_pose", o.rays_per_pose, "at least 1");
  requireOption(o.min_range >= 0, "min_range", o.min_range, "at least 0 m");
  requireOption(o.max_range > o.min_range, "max_range", o.max_range, "above min_range");
  requireOption(o.noise >= 0, "noise", o.noise, "at least 0 m");
  requireOption(o.drift >= 0, "drift", o.drift, "at least 0 m");
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

struct Scene {
  const Building& building;
  RayTracer tracer;
  std::vector<Eigen::Vector3f> normals; // unit
  std::uint32_t ghost;
};

Scene
makeScene(const Building& building)
{
  Scene scene{building, RayTracer(building.triangles), {}, building.category("ghost")};
  for (const auto& t : building.triangles)
    scene.normals.push_back((t.b - t.a).cross(t.c - t.a).normalized());
  return scene;
}

// What a ray brings back: the way it went, and the triangle that sent it back.
struct Echo {
  float range = 0.0f;
  int triangle = -1; // -1: nothing
  bool mirrored = false;
};

// Follow one ray through panes of glass to the surface that returns it.
Echo
follow(const Scene& scene,
       Eigen::Vector3f origin,
       Eigen::Vector3f direction,
       const RangeSensorOptions& options,
       RandomDraw& draw)
{
  constexpr int most_panes = 8;
  constexpr float off_pane = 1e-4f; // metres: do not meet the same pane again
  Echo echo;
  float start = static_cast<float>(options.min_range);
  for (int pane = 0; pane <= most_panes; ++pane) {
    const float left = static_cast<float>(options.max_range) - echo.range;
    const RayHit hit = scene.tracer.trace(origin, direction, start, left);
    if (hit.triangle < 0)
      return {};
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

// What a beam of some width brings back, of which a share hits what is beside its
// middle.
Echo
followBeam(const Scene& scene,
           const Eigen::Vector3f& origin,
           const Eigen::Vector3f& direction,
           const RangeSensorOptions& options,
           RandomDraw& draw)
{
  constexpr float longest_pulse = 0.5f; // metres: echoes farther apart are told apart
  Echo echo = follow(scene, origin, direction, options, draw);
  if (options.beam == 0 || echo.triangle < 0 || echo.mirrored)
    return echo;
  Eigen::Vector3d beside = direction.cast<double>();
  for (int k = 0; k < 3; ++k)
    beside[k] += options.beam * draw.gaussian();
  const float share = static_cast<float>(draw.uniform(0, 0.5));
  const Echo other =
      follow(scene, origin, beside.normalized().cast<float>(), options, draw);
  if (other.triangle >= 0 && !other.mirrored &&
      std::abs(other.range - echo.range) < longest_pulse)
    echo.range += share * (other.range - echo.range);
  return echo;
}

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
scanFrom(const Scene& scene,
         const Eigen::Vector3d& position,
         const RangeSensorOptions& options,
         RandomDraw draw)
{
  constexpr double typical_range =
      5.0; // metres: there the heading's error equals drift
  const double turn = draw.uniform(0.0, 2 * M_PI), shift = draw.uniform();
  Eigen::Vector3d error(draw.gaussian(), draw.gaussian(), 0.5 * draw.gaussian());
  error *= options.drift;
  const double heading_error = draw.gaussian() * options.drift / typical_range;
  const Eigen::Matrix3d heading =
      Eigen::AngleAxisd(heading_error, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Vector3f origin = position.cast<float>();
  std::vector<PointXYZScene> points;
  for (int i = 0; i < options.rays_per_pose; ++i) {
    const auto direction = spiralDirection(i, options.rays_per_pose, turn, shift);
    const Echo echo = followBeam(scene, origin, direction.cast<float>(), options, draw);
    if (echo.triangle < 0)
      continue;
    const double range = echo.range + options.noise * draw.gaussian();
    const Eigen::Vector3d at = position + error + heading * (range * direction);
    PointXYZScene point;
    point.x = static_cast<float>(at.x());
    point.y = static_cast<float>(at.y());
    point.z = static_cast<float>(at.z());
    if (echo.mirrored)
      point.category = scene.ghost;
    else {
      const auto& labels = scene.building.surfaces[echo.triangle].labels;
      point.room = labels.room;
      point.object = labels.object;
      point.part = labels.part;
      point.category = labels.category;
    }
    points.push_back(point);
  }
  return points;
}

} // namespace

double
echoProbability(double cosine, const RangeSensorOptions& options)
{
  const double grazing = 1.0 - std::min(1.0, std::abs(cosine));
  return (1.0 - options.dropout) * (1.0 - std::pow(grazing, options.grazing_exponent));
}

SimulatedScan
scanBuilding(const Building& building,
             const std::vector<Eigen::Vector3d>& positions,
             const RangeSensorOptions& options)
{
  requireLegal(options);
  const Scene scene = makeScene(building);
  const auto pose_count = static_cast<std::ptrdiff_t>(positions.size());
  std::vector<std::vector<PointXYZScene>> per_pose(positions.size());
  std::ptrdiff_t done = 0;
  std::exception_ptr failure; // none may leave a parallel loop
#ifdef _OPENMP
  const int threads = options.threads > 0 ? options.threads : omp_get_max_threads();
#pragma omp parallel for schedule(dynamic) num_threads(threads)
#endif
  for (std::ptrdiff_t i = 0; i < pose_count; ++i) {
    try {
      const auto pose = static_cast<std::uint32_t>(i);
      per_pose[i] = scanFrom(
          scene, positions[i], options, RandomDraw(mixSeed(options.seed, pose)));
    } catch (...) {
#pragma omp critical(pcl_indoor_scan)
      failure = std::current_exception();
    }
#pragma omp critical(pcl_indoor_scan)
    {
      ++done;
      if (options.progress)
        options.progress(static_cast<std::size_t>(done), positions.size());
    }
  }
  if (failure)
    std::rethrow_exception(failure);
  SimulatedScan scan;
  scan.ray_count = positions.size() * static_cast<std::size_t>(options.rays_per_pose);
  for (std::size_t i = 0; i < per_pose.size(); ++i) {
    scan.points.insert(scan.points.end(), per_pose[i].begin(), per_pose[i].end());
    scan.poses.resize(scan.points.size(), static_cast<std::uint32_t>(i));
  }
  return scan;
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

} // namespace indoor
} // namespace pcl
