/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/depth_camera.h>

#include "scanner/option_check.h"

#include <pcl/simulation/random_draw.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

namespace {

using pcl::indoor::CameraPose;
using pcl::indoor::DepthCameraOptions;
using pcl::indoor::RandomDraw;
using pcl::indoor::requireOption;

constexpr int patch = 4; // pixels from one independent error to the next

void
requireLegal(const DepthCameraOptions& o)
{
  requireOption(o.width >= 1, "width", o.width, "at least 1");
  requireOption(o.height >= 1, "height", o.height, "at least 1");
  requireOption(o.focal_length > 0, "focal_length", o.focal_length, "positive");
  requireOption(o.baseline > 0, "baseline", o.baseline, "positive");
  requireOption(o.noise >= 0, "noise", o.noise, "at least 0 pixels");
  requireOption(o.step > 0, "step", o.step, "positive");
  requireOption(o.min_range >= 0, "min_range", o.min_range, "at least 0 m");
  requireOption(o.max_range > o.min_range, "max_range", o.max_range, "above min_range");
  requireOption(o.least_cosine >= 0 && o.least_cosine <= 1,
                "least_cosine",
                o.least_cosine,
                "from 0 to 1");
}

/** Right, down and forwards, as columns. */
Eigen::Matrix3d
cameraAxes(const CameraPose& pose)
{
  const Eigen::Vector3d way = pose.target - pose.position;
  if (!(way.norm() > 0))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "the camera's target is where the camera is");
  Eigen::Matrix3d axes;
  axes.col(2) = way.normalized();
  const Eigen::Vector3d right = axes.col(2).cross(Eigen::Vector3d::UnitZ());
  axes.col(0) = right.norm() > 1e-6 ? Eigen::Vector3d(right.normalized())
                                    : Eigen::Vector3d(Eigen::Vector3d::UnitX());
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

/** Errors that change smoothly from pixel to pixel, with standard deviation 1. */
class PatchNoise {
public:
  PatchNoise(int width, int height, RandomDraw draw)
  : nodes_(height / patch + 2, width / patch + 2)
  {
    for (Eigen::Index i = 0; i < nodes_.size(); ++i)
      nodes_(i) = draw.gaussian();
  }

  double
  at(int u, int v) const
  {
    const double x = static_cast<double>(u % patch) / patch,
                 y = static_cast<double>(v % patch) / patch;
    const Eigen::Vector2d across(1 - x, x), down(1 - y, y);
    const double sum = down.dot(nodes_.block<2, 2>(v / patch, u / patch) * across);
    return sum / (across.norm() * down.norm());
  }

private:
  Eigen::MatrixXd nodes_;
};

} // namespace

namespace pcl {
namespace indoor {

CameraPose
drawCameraPose(const Building& building,
               const TrajectoryOptions& walk,
               std::uint32_t seed)
{
  constexpr double nearest = 1, farthest = 4; // metres
  const RayTracer tracer(building.triangles);
  const auto is_seen = [&](const CameraPose& pose, std::uint32_t object) {
    const Eigen::Vector3d way = pose.target - pose.position;
    if (way.norm() < nearest || way.norm() > farthest)
      return false;
    const auto hit = tracer.trace(
        pose.position.cast<float>(), way.normalized().cast<float>(), 0, farthest);
    if (hit.triangle < 0)
      return false;
    const auto& surface = building.surfaces[hit.triangle];
    return surface.labels.object == object && !surface.isGlass();
  };
  std::vector<CameraPose> poses;
  for (const auto& position : planTrajectory(building, walk))
    for (std::uint32_t o = 0; o < building.objects.size(); ++o) {
      const auto& object = building.objects[o];
      const CameraPose pose{
          position, object.position + 0.5 * object.size.z() * Eigen::Vector3d::UnitZ()};
      if (is_seen(pose, o + 1))
        poses.push_back(pose);
    }
  if (poses.empty())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "no position of the walk sees an object from "
                            << nearest << " to " << farthest << " m away");
  return poses[RandomDraw(mixSeed(seed, 0)).pick(static_cast<int>(poses.size()))];
}

PointCloud<PointXYZScene>
viewBuilding(const Building& building,
             const CameraPose& pose,
             const DepthCameraOptions& options)
{
  requireLegal(options);
  const auto& position = pose.position;
  const Eigen::Matrix3d axes = cameraAxes(pose);
  const Eigen::Vector3d projector = position + options.baseline * axes.col(0);
  const RayTracer tracer(building.triangles);
  const PatchNoise errors(options.width, options.height, RandomDraw(options.seed));
  const float none = std::numeric_limits<float>::quiet_NaN();
  PointXYZScene unseen;
  unseen.x = unseen.y = unseen.z = none;
  PointCloud<PointXYZScene> view(static_cast<std::uint32_t>(options.width),
                                 static_cast<std::uint32_t>(options.height),
                                 unseen);
  view.is_dense = false;

  const auto is_lit = [&](const Eigen::Vector3d& place) {
    constexpr float nearly = 0.999f; // the surface itself is no obstacle
    const Eigen::Vector3f way = (place - projector).cast<float>();
    return tracer.trace(projector.cast<float>(), way, 0, nearly).triangle < 0;
  };
  for (int v = 0; v < options.height; ++v)
    for (int u = 0; u < options.width; ++u) {
      const Eigen::Vector3d ray((u - 0.5 * (options.width - 1)) / options.focal_length,
                                (v - 0.5 * (options.height - 1)) / options.focal_length,
                                1);
      const Eigen::Vector3d way = axes * ray; // as long as the depth
      const auto hit = tracer.trace(position.cast<float>(),
                                    way.cast<float>(),
                                    static_cast<float>(options.min_range),
                                    static_cast<float>(options.max_range));
      if (hit.triangle < 0)
        continue;
      const auto& surface = building.surfaces[hit.triangle];
      const auto& t = building.triangles[hit.triangle];
      const double cosine =
          (t.b - t.a).cross(t.c - t.a).normalized().dot(way.normalized().cast<float>());
      const double depth = hit.distance;
      if (surface.isGlass() || std::abs(cosine) < options.least_cosine ||
          !is_lit(position + depth * way))
        continue;
      const double scale = options.focal_length * options.baseline;
      const double disparity =
          std::round((scale / depth + options.noise * errors.at(u, v)) / options.step) *
          options.step;
      if (!(disparity > 0))
        continue;
      const Eigen::Vector3f place = (scale / disparity * ray).cast<float>();
      auto& point = view.at(u, v);
      point.x = place.x();
      point.y = place.y();
      point.z = place.z();
      point.room = surface.labels.room;
      point.object = surface.labels.object;
      point.part = surface.labels.part;
      point.category = surface.labels.category;
    }
  return view;
}

} // namespace indoor
} // namespace pcl
