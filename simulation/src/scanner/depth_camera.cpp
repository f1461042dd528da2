/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/depth_camera.h>

#include "scanner/depth_sensor.h"

#include <pcl/simulation/random_draw.h>

#include <Eigen/Geometry>

#include <limits>

namespace pcl::indoor {

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
  const auto pixels = DepthSensor(building, options).see(frameOf(pose), options.seed);
  const float none = std::numeric_limits<float>::quiet_NaN();
  PointXYZScene unseen;
  unseen.x = unseen.y = unseen.z = none;
  PointCloud<PointXYZScene> view(static_cast<std::uint32_t>(options.width),
                                 static_cast<std::uint32_t>(options.height),
                                 unseen);
  view.is_dense = false;
  for (int v = 0; v < options.height; ++v)
    for (int u = 0; u < options.width; ++u) {
      const auto& pixel = pixels[static_cast<std::size_t>(v) * options.width + u];
      if (pixel.depth == 0)
        continue;
      const Eigen::Vector3f place =
          (pixel.depth * rayThrough(u, v, options)).cast<float>();
      const auto& labels = building.surfaces[pixel.triangle].labels;
      view.at(u, v) = {place.x(),
                       place.y(),
                       place.z(),
                       labels.room,
                       labels.object,
                       labels.part,
                       labels.category};
    }
  return view;
}

} // namespace pcl::indoor
