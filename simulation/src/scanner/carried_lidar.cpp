/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/carried_lidar.h>

#include "scanner/moving_people.h"
#include "scanner/option_check.h"
#include "scanner/path_drift.h"
#include "scanner/ray_echo.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

// Independent draws of one seed, apart from those of the frames, which count from 0.
enum Purpose : std::uint32_t { for_sway = 0xF0000000u, for_people, for_drift };

void
requireLegal(const CarriedLidarOptions& o)
{
  requireLegal(static_cast<const EchoOptions&>(o));
  const auto isBetween = [](double value, double least, double most) {
    return value >= least && value <= most;
  };
  requireOption(isBetween(o.rings, 1, 256), "rings", o.rings, "from 1 to 256");
  requireOption(isBetween(o.steps_per_turn, 1, 1e5),
                "steps_per_turn",
                o.steps_per_turn,
                "from 1 to 100000");
  requireOption(isBetween(o.rays_per_frame, 1, 1e7),
                "rays_per_frame",
                o.rays_per_frame,
                "from 1 to 10000000");
  requireOption(o.lowest_ring > -M_PI / 2 && o.lowest_ring <= o.highest_ring,
                "lowest_ring",
                o.lowest_ring,
                "above -pi/2 and at most highest_ring");
  requireOption(
      o.highest_ring < M_PI / 2, "highest_ring", o.highest_ring, "below pi/2");
  for (const double field : {o.field_width, o.field_height})
    requireOption(field > 0 && field < M_PI, "field", field, "between 0 and pi");
  requireOption(o.turn_rate >= 0.1, "turn_rate", o.turn_rate, "at least 0.1 1/s");
  requireOption(isBetween(o.frame_rate, 0.001, 1000),
                "frame_rate",
                o.frame_rate,
                "from 0.001 to 1000 1/s");
  requireOption(o.drift >= 0, "drift", o.drift, "at least 0 m");
  requireOption(o.people >= 0 && o.people <= 10, "people", o.people, "from 0 to 10");
}

Eigen::Vector3d
directionOf(double azimuth, double elevation)
{
  return {std::cos(elevation) * std::cos(azimuth),
          std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

// The rays of a frame in the sensor's own axes, and when they are sent.
class FramePattern {
public:
  FramePattern(const CarriedLidarOptions& options, double start, double phase)
  : options_(options)
  , start_(start)
  , phase_(phase)
  {}

  static int
  rays(const CarriedLidarOptions& o)
  {
    return o.pattern == LidarPattern::Spinning ? o.rings * o.steps_per_turn
                                               : o.rays_per_frame;
  }

  double
  timeOf(int ray) const
  {
    const auto& o = options_;
    const int together = o.pattern == LidarPattern::Spinning ? o.rings : 1;
    return start_ + static_cast<double>(ray / together) /
                        (static_cast<double>(rays(o) / together) * o.turn_rate);
  }

  Eigen::Vector3d
  directionOf(int ray) const
  {
    return options_.pattern == LidarPattern::Spinning ? ofRing(ray) : ofRosette(ray);
  }

private:
  Eigen::Vector3d
  ofRing(int ray) const
  {
    const auto& o = options_;
    const double share = o.rings > 1 ? (ray % o.rings) / (o.rings - 1.0) : 0.5;
    const double step = static_cast<double>(ray / o.rings) / o.steps_per_turn;
    return indoor::directionOf(phase_ + 2 * M_PI * step,
                               o.lowest_ring +
                                   share * (o.highest_ring - o.lowest_ring));
  }

  // Two prisms bend the beam by a quarter of the field each (a Risley pair).
  Eigen::Vector3d
  ofRosette(int ray) const
  {
    constexpr double first = 7294.0 / 60,
                     second = -4664.0 / 60; // turns/s: Livox Mid-40
    const double time = timeOf(ray);
    const double a = 2 * M_PI * first * time, b = 2 * M_PI * second * time;
    return indoor::directionOf(options_.field_width / 4 * (std::cos(a) + std::cos(b)),
                               options_.field_height / 4 * (std::sin(a) + std::sin(b)));
  }

  const CarriedLidarOptions& options_;
  double start_, phase_;
};

// How a hand moves: offsets in metres ahead, left and up, and angles in radians.
struct Sway {
  Eigen::Vector3d shift;
  double roll, pitch;
};

Sway
swayAt(double time, std::uint32_t seed)
{
  constexpr double steps = 1.8; // per second
  std::uint32_t waves = 0;
  const auto wave = [&](double frequency) {
    const double phase = mixSeed(mixSeed(seed, for_sway), ++waves) / 4294967296.0;
    return std::sin(2 * M_PI * (frequency * time + phase));
  };
  Sway sway;
  const double ahead = 0.02 * wave(steps), left = 0.03 * wave(steps / 2);
  sway.shift = {ahead, left, 0.02 * wave(steps) + 0.15 * wave(0.05)};
  sway.roll = 0.05 * wave(steps / 2) + 0.15 * wave(0.11);
  sway.pitch = 0.03 * wave(steps) + 0.2 * wave(0.07) + 0.1 * wave(0.17);
  return sway;
}

// Who walks with the sensor: how many seconds after it, negative before it.
std::vector<double>
drawLags(const CarriedPath& path, const CarriedLidarOptions& options)
{
  constexpr double nearest = 1.5, apart = 1.5; // metres
  RandomDraw draw(mixSeed(options.seed, for_people));
  const double end = path.back().time;
  const double speed = end > 0 ? std::max(0.1, path.back().way / end) : 1.0;
  std::vector<double> lags;
  for (int i = 0; i < options.people; ++i) {
    const double distance = nearest + apart * (i / 2 + draw.uniform());
    lags.push_back((i % 2 == 0 ? 1.0 : -1.0) * distance / speed);
  }
  return lags;
}

// A path with all that is drawn once for it.
struct Walk {
  const CarriedPath& path;
  PathDrift drift;
  std::vector<double> lags;
};

std::vector<StandingPerson>
peopleAt(const Building& building,
         const Walk& walk,
         double time,
         const CarriedLidarOptions& options)
{
  constexpr double aside = 0.6; // metres: who would be nearer steps aside
  const PathPoint here = placeAt(walk.path, time);
  std::vector<StandingPerson> people;
  const auto feetAt = [](const PathPoint& place) {
    return Eigen::Vector3d(place.position.x(), place.position.y(), place.floor);
  };
  for (const double lag : walk.lags) {
    const double then = time - lag;
    if (then < 0 || then > walk.path.back().time)
      continue;
    const PathPoint place = placeAt(walk.path, then);
    if ((place.position - here.position).head<2>().norm() > aside)
      people.push_back(personAt(building, feetAt(place)));
  }
  if (options.carrier == LidarCarrier::Person) {
    constexpr double arm = 0.45; // metres
    Eigen::Vector3d feet = feetAt(here);
    feet.head<2>() -=
        arm * Eigen::Vector2d(std::cos(here.heading), std::sin(here.heading));
    people.push_back(personAt(building, feet));
  }
  return people;
}

// Scans one frame.
class FrameScanner {
public:
  FrameScanner(const RayScene& scene, const Walk& walk, const CarriedLidarOptions& o)
  : scene_(scene)
  , walk_(walk)
  , options_(o)
  , person_category_(scene.building.category("person"))
  {}

  std::vector<PointXYZScene>
  scan(double start, RandomDraw draw) const
  {
    const FramePattern pattern(options_, start, draw.uniform(0.0, 2 * M_PI));
    const auto people = peopleAt(scene_.building, walk_, start, options_);
    std::vector<PointXYZScene> points;
    double time = -1.0;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity(), registered = pose;
    for (int i = 0; i < FramePattern::rays(options_); ++i) {
      if (pattern.timeOf(i) != time) {
        time = pattern.timeOf(i);
        pose = sensorPose(walk_.path, time, options_);
        registered = registeredPose(pose, time);
      }
      const Eigen::Vector3d ray = pattern.directionOf(i);
      auto [point, range] = send(pose.translation(), pose.linear() * ray, people, draw);
      if (point.category == 0)
        continue;
      const Eigen::Vector3d at =
          registered * ((range + options_.noise * draw.gaussian()) * ray);
      place(point, at);
      points.push_back(point);
    }
    return points;
  }

private:
  Eigen::Isometry3d
  registeredPose(const Eigen::Isometry3d& pose, double time) const
  {
    const PoseError error = walk_.drift.at(time);
    Eigen::Isometry3d registered = pose;
    registered.linear() =
        Eigen::AngleAxisd(error.turn, Eigen::Vector3d::UnitZ()) * pose.linear();
    registered.translation() += error.shift;
    return registered;
  }

  // The labels of what a ray meets, category 0 for nothing, and how far away it is.
  std::pair<PointXYZScene, double>
  send(const Eigen::Vector3d& origin,
       const Eigen::Vector3d& direction,
       const std::vector<StandingPerson>& people,
       RandomDraw& draw) const
  {
    double reach = options_.max_range;
    const StandingPerson* met = nullptr;
    for (const auto& person : people)
      if (const double d = distanceTo(person, origin, direction); d < reach) {
        reach = d;
        met = &person;
      }
    const Echo echo = followBeam(scene_,
                                 origin.cast<float>(),
                                 direction.cast<float>(),
                                 static_cast<float>(reach),
                                 options_,
                                 draw);
    if (echo.triangle >= 0)
      return {labelledPoint(scene_, echo, Eigen::Vector3d::Zero()), echo.range};
    PointXYZScene point;
    if (met && echo.unhindered && !echo.mirrored && reach >= options_.min_range &&
        draw.uniform() < 1.0 - options_.dropout) {
      point.room = met->room;
      point.category = person_category_;
    }
    return {point, reach};
  }

  const RayScene& scene_;
  const Walk& walk_;
  const CarriedLidarOptions& options_;
  std::uint32_t person_category_;
};

} // namespace

CarriedLidarOptions
lidarOptions(LidarModel model)
{
  CarriedLidarOptions options;
  options.min_range = 0.5;
  options.noise = 0.02;
  if (model == LidarModel::SolidState)
    options.pattern = LidarPattern::NonRepeating;
  if (model == LidarModel::Walk)
    options.carrier = LidarCarrier::Person;
  return options;
}

PathOptions
pathOptions(LidarModel model)
{
  PathOptions options;
  options.spacing = 4.0;
  options.sensor_height = model == LidarModel::Walk ? 1.4 : 0.6;
  options.speed = model == LidarModel::Walk ? 1.1 : 0.8;
  options.look_around = model == LidarModel::SolidState;
  return options;
}

std::vector<LidarFrame>
framesOn(const std::vector<CarriedPath>& paths, const CarriedLidarOptions& options)
{
  requireLegal(options);
  std::vector<LidarFrame> frames;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    requireOption(!paths[p].empty(), "points of a path", 0, "at least 1");
    const double last = paths[p].back().time - 1.0 / options.turn_rate;
    const int count = 1 + static_cast<int>(std::max(0.0, last) * options.frame_rate);
    for (int k = 0; k < count; ++k)
      frames.push_back({p, k / options.frame_rate});
  }
  return frames;
}

Eigen::Isometry3d
sensorPose(const CarriedPath& path, double time, const CarriedLidarOptions& options)
{
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  const PathPoint place = placeAt(path, time);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = place.position;
  double heading = place.heading;
  if (options.pattern == LidarPattern::NonRepeating) {
    constexpr double widest = 50 * M_PI / 180, period = 8.0; // seconds
    heading += widest * std::sin(2 * M_PI * time / period);
  }
  pose.linear() = AngleAxisd(heading, Vector3d::UnitZ()).toRotationMatrix();
  if (options.carrier == LidarCarrier::Person) {
    const Sway sway = swayAt(time, options.seed);
    pose.translation() += pose.linear() * sway.shift;
    pose.linear() *= (AngleAxisd(sway.pitch, Vector3d::UnitY()) *
                      AngleAxisd(sway.roll, Vector3d::UnitX()))
                         .toRotationMatrix();
  }
  return pose;
}

SimulatedScan
scanAlong(const Building& building,
          const std::vector<CarriedPath>& paths,
          const CarriedLidarOptions& options)
{
  const auto frames = framesOn(paths, options);
  const RayScene scene(building);
  std::vector<Walk> walks;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    const auto seed = mixSeed(options.seed, for_drift + static_cast<std::uint32_t>(p));
    walks.push_back({paths[p],
                     PathDrift(paths[p], options.drift, RandomDraw(seed)),
                     drawLags(paths[p], options)});
  }
  std::vector<FrameScanner> scanners;
  for (const auto& walk : walks)
    scanners.emplace_back(scene, walk, options);
  return scanFromPoses(frames.size(),
                       static_cast<std::size_t>(FramePattern::rays(options)),
                       options,
                       [&](std::size_t frame, const RandomDraw& draw) {
                         return scanners[frames[frame].path].scan(frames[frame].time,
                                                                  draw);
                       });
}

} // namespace pcl::indoor
