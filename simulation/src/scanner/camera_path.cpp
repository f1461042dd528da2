/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scanner/camera_path.h"

#include "scanner/free_places.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

/** Where somebody stops and how they look around there. */
struct Stop {
  Eigen::Vector3d at;
  double from, to; // headings, radians
};

/** Stops in a room, from one to the nearest that is left. */
std::vector<Stop>
stopsIn(const Level& level, const CameraPathOptions& options, RandomDraw& draw)
{
  constexpr double clearance = 0.2; // metres: where somebody can stand
  // by which they look around at a stop, radians
  constexpr double least_turn = M_PI, most_turn = 2 * M_PI;
  auto left = spread(placesOn(level, options.highest), options.spacing, clearance);
  std::vector<Stop> stops;
  double heading = draw.uniform(0, 2 * M_PI);
  while (!left.empty()) {
    auto nearest = left.begin();
    if (!stops.empty())
      nearest = std::min_element(left.begin(), left.end(), [&](auto& a, auto& b) {
        const Eigen::Vector2d here = stops.back().at.head<2>();
        return (a - here).squaredNorm() < (b - here).squaredNorm();
      });
    const double turn = draw.uniform(least_turn, most_turn);
    const double side = draw.pick(2) == 0 ? -1 : 1;
    const double height = draw.uniform(options.lowest, options.highest);
    stops.push_back({level.sensorAt(*nearest, height), heading, heading + side * turn});
    heading = stops.back().to;
    left.erase(nearest);
  }
  return stops;
}

/** Writes the frames of a path, which looks up and down as it goes on. */
class FrameWriter {
public:
  explicit FrameWriter(RandomDraw& draw)
  : phase_(draw.uniform(0, 2 * M_PI))
  {}

  void
  add(const Eigen::Vector3d& at, double heading)
  {
    constexpr double frames_up_and_down = 9;
    constexpr double lowest = -0.8, highest = 0; // of the axis, radians
    phase_ += 2 * M_PI / frames_up_and_down;
    const double slope =
        std::tan((highest + lowest) / 2 + (highest - lowest) / 2 * std::sin(phase_));
    frames.push_back(frameOf(
        {at, at + Eigen::Vector3d(std::cos(heading), std::sin(heading), slope)}));
  }

  std::vector<CameraFrame> frames;

private:
  double phase_; // of looking up and down, radians
};

} // namespace

std::vector<CameraFrame>
cameraPath(const Building& building,
           std::uint32_t room,
           const RayTracer& tracer,
           const CameraPathOptions& options,
           RandomDraw draw)
{
  constexpr double turn_step = 12 * M_PI / 180; // between frames: a fifth of the view
  constexpr double way_step = 0.3;              // metres between frames
  const auto stops = stopsIn({building, room, nullptr}, options, draw);
  FrameWriter writer(draw);
  for (std::size_t s = 0; s < stops.size(); ++s) {
    const auto& stop = stops[s];
    const double turn = stop.to - stop.from;
    const int turns = static_cast<int>(std::abs(turn) / turn_step);
    for (int i = 0; i <= turns; ++i)
      writer.add(stop.at, stop.from + turn * i / std::max(turns, 1));
    if (s + 1 == stops.size())
      break;
    const Eigen::Vector3d way = stops[s + 1].at - stop.at;
    if (tracer.trace(stop.at.cast<float>(), way.cast<float>(), 0, 1).triangle >= 0)
      continue; // something is in the way: they go round it, looking elsewhere
    const int steps = static_cast<int>(way.norm() / way_step);
    for (int i = 1; i < steps; ++i)
      writer.add(stop.at + way * i / steps, stop.to);
  }
  return writer.frames;
}

std::vector<CameraFrame>
registeredFrames(const std::vector<CameraFrame>& frames, double drift, RandomDraw draw)
{
  constexpr double lasting = 30;      // frames that an error lasts
  constexpr double typical_range = 2; // metres
  const double kept = std::exp(-1 / lasting), fresh = std::sqrt(1 - kept * kept);
  Eigen::Matrix<double, 6, 1> error;
  for (int k = 0; k < 6; ++k)
    error[k] = draw.gaussian();
  std::vector<CameraFrame> registered;
  for (const auto& frame : frames) {
    for (int k = 0; k < 6; ++k)
      error[k] = kept * error[k] + fresh * draw.gaussian();
    const Eigen::Vector3d turn = drift / typical_range * error.tail<3>();
    const double angle = turn.norm();
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    if (angle > 0)
      rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
    registered.push_back(
        {frame.position + drift * error.head<3>(), rotation * frame.axes});
  }
  return registered;
}

} // namespace pcl::indoor
