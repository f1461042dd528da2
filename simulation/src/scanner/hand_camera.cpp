/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/hand_camera.h>

#include "scanner/camera_path.h"
#include "scanner/distance_volume.h"
#include "scanner/option_check.h"

#include <pcl/indoor/parallel_for.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <tuple>

namespace pcl::indoor {

namespace {

constexpr double sway = 0.25; // metres that the camera is held higher or lower

void
requireLegal(const HandCameraOptions& o)
{
  requireOption(o.spacing > 0, "spacing", o.spacing, "positive");
  requireOption(o.height > sway, "height", o.height, "above 0.25 m");
  requireOption(o.noise >= 0, "noise", o.noise, "at least 0 m");
  requireOption(o.drift >= 0, "drift", o.drift, "at least 0 m");
  requireOption(o.voxel_size >= 0.005 && o.voxel_size <= 0.2,
                "voxel_size",
                o.voxel_size,
                "from 0.005 to 0.2 m");
  requireOption(o.most_points >= 1,
                "most_points",
                static_cast<double>(o.most_points),
                "at least 1");
  requireOption(o.threads >= 0, "threads", o.threads, "at least 0");
}

/** The different labels of a building's surfaces. */
struct LabelTable {
  std::vector<SceneLabels> labels;
  std::vector<int> of_triangle;

  explicit LabelTable(const Building& building)
  {
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>,
             int>
        numbers;
    for (const auto& surface : building.surfaces) {
      const auto& l = surface.labels;
      const auto [found, is_new] =
          numbers.emplace(std::make_tuple(l.room, l.object, l.part, l.category),
                          static_cast<int>(labels.size()));
      if (is_new)
        labels.push_back(l);
      of_triangle.push_back(found->second);
    }
  }
};

Eigen::Matrix3d
anyRotation(RandomDraw draw)
{
  Eigen::Vector4d q;
  for (int k = 0; k < 4; ++k)
    q[k] = draw.gaussian();
  return Eigen::Quaterniond(q.normalized()).toRotationMatrix();
}

/** Fuse all views of a path, in a grid that is turned anyhow: the map of a capture
 * knows nothing of walls. */
std::vector<LabelledVertex>
fuse(const DepthSensor& sensor,
     const std::vector<CameraFrame>& frames,
     const LabelTable& table,
     const HandCameraOptions& options)
{
  constexpr std::size_t at_once = 32;   // views in memory
  constexpr float least_weight = 0.33f; // 1/m^2: three views from 3 m
  const Eigen::Matrix3d turn = anyRotation(RandomDraw(mixSeed(options.seed, 4)));
  auto places =
      registeredFrames(frames, options.drift, RandomDraw(mixSeed(options.seed, 1)));
  for (auto& place : places)
    place = {turn * place.position, turn * place.axes};
  DistanceVolume volume(options.voxel_size, options.threads);
  std::vector<std::vector<DepthPixel>> views(at_once);
  for (std::size_t begin = 0; begin < frames.size(); begin += at_once) {
    const auto count = std::min(at_once, frames.size() - begin);
    const auto views_at_once = static_cast<std::ptrdiff_t>(count);
    parallelFor(views_at_once, options.threads, 1, [&](std::ptrdiff_t i) {
      const auto view = static_cast<std::uint32_t>(begin + i);
      views[i] = sensor.see(frames[begin + i], mixSeed(options.seed, 16 + view));
      for (auto& pixel : views[i])
        if (pixel.triangle >= 0)
          pixel.triangle = table.of_triangle[pixel.triangle];
    });
    for (std::size_t i = 0; i < count; ++i)
      volume.integrate(views[i], places[begin + i], options.camera);
    if (options.progress)
      options.progress(begin + count, frames.size());
  }
  auto vertices = volume.vertices(least_weight);
  for (auto& vertex : vertices)
    vertex.at = turn.cast<float>().transpose() * vertex.at;
  return vertices;
}

/** Draw some of the points; they keep their order. */
void
drawPoints(std::vector<PointXYZScene>& points, std::size_t most, RandomDraw draw)
{
  std::vector<PointXYZScene> kept;
  auto wanted = std::min(most, points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (draw.uniform() * static_cast<double>(points.size() - i) <
        static_cast<double>(wanted)) {
      kept.push_back(points[i]);
      --wanted;
    }
  points = std::move(kept);
}

} // namespace

HandCameraOptions::HandCameraOptions()
{
  // Every fourth pixel of a Kinect: each has the error of a whole patch of its pattern.
  camera.width /= 4;
  camera.height /= 4;
  camera.focal_length /= 4;
  camera.step /= 4;
  camera.patch = 1;
  camera.max_range = 4;
  camera.distortion = 0.04;
  camera.edge_noise = 0.25;
  camera.mixed = 0.3;
  camera.dark = 0.03;
}

SimulatedScan
captureRoom(const Building& building,
            std::uint32_t room,
            const HandCameraOptions& options)
{
  requireLegal(options);
  requireOption(
      room >= 1 && room <= building.rooms.size(), "room", room, "the number of a room");
  auto camera = options.camera;
  camera.seed = options.seed;
  camera.noise = options.noise * camera.focal_length * camera.baseline;
  const DepthSensor sensor(building, camera);
  CameraPathOptions path;
  path.spacing = options.spacing;
  path.lowest = options.height - sway;
  path.highest = options.height + sway;
  const auto frames = cameraPath(
      building, room, sensor.tracer(), path, RandomDraw(mixSeed(options.seed, 2)));
  const LabelTable table(building);
  SimulatedScan scan;
  scan.ray_count = frames.size() * camera.width * camera.height;
  for (const auto& vertex : fuse(sensor, frames, table, options)) {
    const auto& l = table.labels[vertex.label];
    const auto& at = vertex.at;
    scan.points.push_back(
        {at.x(), at.y(), at.z(), l.room, l.object, l.part, l.category});
  }
  scan.poses.assign(scan.points.size(), 0);
  thinScan(scan, options.voxel_size / 2); // meshes are freed of slivers
  drawPoints(scan.points, options.most_points, RandomDraw(mixSeed(options.seed, 3)));
  scan.poses.assign(scan.points.size(), 0);
  return scan;
}

} // namespace pcl::indoor
