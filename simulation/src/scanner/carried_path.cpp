/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/carried_path.h>

#include "scanner/option_check.h"
#include "scanner/roadmap.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace pcl::indoor {

namespace {

constexpr double path_step = 0.1; // seconds between points of a path

void
requireLegal(const PathOptions& o)
{
  requireOption(o.spacing > 0, "spacing", o.spacing, "positive");
  requireOption(o.sensor_height > 0, "sensor_height", o.sensor_height, "positive");
  requireOption(o.clearance >= 0, "clearance", o.clearance, "at least 0 m");
  requireOption(
      o.speed >= 0.05 && o.speed <= 20, "speed", o.speed, "from 0.05 to 20 m/s");
  requireOption(o.entered >= 0 && o.entered <= 1, "entered", o.entered, "from 0 to 1");
}

// A polygonal line of sensor positions with the floor below each.
struct Line {
  std::vector<Eigen::Vector3d> corners;
  std::vector<double> floors;
  std::vector<double> ways;  // metres from the start to each corner
  std::vector<double> stops; // ways at which the carrier stops

  void
  add(const Eigen::Vector3d& corner, double floor)
  {
    const double leg = corners.empty() ? 0.0 : (corner - corners.back()).norm();
    ways.push_back(corners.empty() ? 0.0 : ways.back() + leg);
    corners.push_back(corner);
    floors.push_back(floor);
  }

  // Position, and the floor as a fourth coordinate.
  Eigen::Vector4d
  at(double way) const
  {
    const auto corner = [&](std::size_t i) {
      return Eigen::Vector4d(corners[i].x(), corners[i].y(), corners[i].z(), floors[i]);
    };
    const auto after = std::upper_bound(ways.begin(), ways.end(), way);
    if (after == ways.begin())
      return corner(0);
    if (after == ways.end())
      return corner(corners.size() - 1);
    const auto i = static_cast<std::size_t>(after - ways.begin());
    const double share = (way - ways[i - 1]) / (ways[i] - ways[i - 1]);
    return corner(i - 1) + share * (corner(i) - corner(i - 1));
  }

  double
  length() const
  {
    return ways.back();
  }
};

// From stop to stop, always the nearest one left, and back.
Line
tour(const Roadmap& roadmap, const std::vector<int>& stops)
{
  Line line;
  std::vector<char> wanted(roadmap.size(), 0);
  for (const int stop : stops)
    wanted[stop] = 1;
  const auto reach = [&](int stop) {
    wanted[stop] = 0;
    line.stops.push_back(line.length());
  };
  int here = stops.front();
  line.add(roadmap[here].at, roadmap[here].floor);
  reach(here);
  const auto walk = [&] {
    const auto way = wayToNearest(roadmap, here, wanted);
    for (std::size_t i = 1; i < way.size(); ++i)
      line.add(roadmap[way[i]].at, roadmap[way[i]].floor);
    if (!way.empty())
      here = way.back();
    return !way.empty();
  };
  while (walk())
    reach(here);
  std::fill(wanted.begin(), wanted.end(), 0);
  wanted[stops.front()] = 1;
  walk();
  return line;
}

// Nobody walks along the corners of a grid: the mean over the way just before and
// after. The ends stay.
Eigen::Vector4d
roundedAt(const Line& line, double way)
{
  constexpr int samples = 8;                                     // on each side
  const double half = std::min({0.4, way, line.length() - way}); // metres
  Eigen::Vector4d mean = line.at(way);
  for (int k = 1; k <= samples; ++k)
    mean += line.at(way - half * k / samples) + line.at(way + half * k / samples);
  return mean / (2 * samples + 1);
}

// Points of the line, rounded where nothing is cut off by that.
std::vector<Eigen::Vector4d>
pointsAt(const Line& line, const std::vector<double>& ways, const RayTracer& tracer)
{
  std::vector<Eigen::Vector4d> points;
  for (const double way : ways)
    points.push_back(roundedAt(line, way));
  std::vector<char> exact(points.size(), 0);
  const auto makeExact = [&](std::size_t i) {
    exact[i] = 1;
    points[i] = line.at(ways[i]);
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 1; i < points.size(); ++i)
      if (!(exact[i - 1] && exact[i]) &&
          !isClear(tracer, points[i - 1].head<3>(), points[i].head<3>())) {
        makeExact(i - 1);
        makeExact(i);
        changed = true;
      }
  }
  return points;
}

// Adds points to a path, with a heading that follows the way as fast as one turns.
class PathWriter {
public:
  void
  step(const Eigen::Vector4d& at, double way, double towards)
  {
    constexpr double fastest = M_PI / 2; // radians per second
    PathPoint point;
    point.time = path_step * static_cast<double>(path_.size());
    point.way = way;
    point.position = at.head<3>();
    point.floor = at.w();
    point.heading = towards;
    if (!path_.empty()) {
      const double before = path_.back().heading;
      const double turn = std::remainder(towards - before, 2 * M_PI);
      const double most = fastest * path_step;
      point.heading = before + std::max(-most, std::min(most, turn));
    }
    path_.push_back(point);
  }

  void
  lookAround()
  {
    constexpr double period = 6.0; // seconds for a full turn
    const int steps = static_cast<int>(period / path_step);
    const PathPoint at = path_.back();
    for (int k = 1; k <= steps; ++k) {
      PathPoint point = at;
      point.time = at.time + k * path_step;
      point.heading = at.heading + 2 * M_PI * k / steps;
      path_.push_back(point);
    }
  }

  CarriedPath path_;
};

// Ways at the times of a path's points.
std::vector<double>
waysOf(const Line& line, double speed)
{
  const double step = speed * path_step;
  const auto steps = static_cast<std::size_t>(std::ceil(line.length() / step - 1e-9));
  std::vector<double> ways;
  for (std::size_t k = 0; k <= steps; ++k)
    ways.push_back(std::min(line.length(), static_cast<double>(k) * step));
  return ways;
}

CarriedPath
walkAlong(const Line& line,
          const std::vector<double>& ways,
          const std::vector<Eigen::Vector4d>& points,
          bool look_around)
{
  constexpr double ahead = 0.3; // metres: where the carrier looks
  PathWriter writer;
  std::size_t stop = 0;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const Eigen::Vector2d look =
        (line.at(ways[k] + ahead) - line.at(ways[k] - ahead)).head<2>();
    const double before = writer.path_.empty() ? 0.0 : writer.path_.back().heading;
    writer.step(points[k],
                ways[k],
                look.norm() > 1e-6 ? std::atan2(look.y(), look.x()) : before);
    bool stops = false;
    for (; stop < line.stops.size() && line.stops[stop] <= ways[k]; ++stop)
      stops = true;
    if (stops && look_around)
      writer.lookAround();
  }
  return writer.path_;
}

} // namespace

std::vector<CarriedPath>
planPaths(const Building& building, const PathOptions& options)
{
  requireLegal(options);
  const RayTracer tracer(building.triangles);
  std::set<std::uint32_t> storeys;
  for (const auto& room : building.rooms)
    storeys.insert(room.storey);
  std::vector<CarriedPath> paths;
  for (const auto storey : storeys) {
    const auto all = buildRoadmap(building, storey, options.sensor_height, tracer);
    const auto roadmap = enteredPart(
        largestPart(all), options.entered, RandomDraw(mixSeed(options.seed, storey)));
    const auto stops = stopsOn(roadmap, options);
    if (stops.empty())
      continue;
    const Line line = tour(roadmap, stops);
    const auto ways = waysOf(line, options.speed);
    paths.push_back(
        walkAlong(line, ways, pointsAt(line, ways, tracer), options.look_around));
  }
  return paths;
}

CarriedPath
pathThrough(const std::vector<Eigen::Vector3d>& positions, const PathOptions& options)
{
  requireLegal(options);
  Line line;
  for (const auto& position : positions) {
    line.add(position, position.z() - options.sensor_height);
    line.stops.push_back(line.length());
  }
  if (positions.empty())
    return {};
  const auto ways = waysOf(line, options.speed);
  std::vector<Eigen::Vector4d> points;
  for (const double way : ways)
    points.push_back(line.at(way));
  return walkAlong(line, ways, points, options.look_around);
}

PathPoint
placeAt(const CarriedPath& path, double time)
{
  const double last = static_cast<double>(path.size() - 1);
  const double index = std::max(0.0, std::min(last, time / path_step));
  const auto i = static_cast<std::size_t>(index);
  const auto j = std::min(i + 1, path.size() - 1);
  const double share = index - static_cast<double>(i);
  const PathPoint &a = path[i], &b = path[j];
  const auto between = [&](double x, double y) { return x + share * (y - x); };
  PathPoint point;
  point.time = time;
  point.way = between(a.way, b.way);
  point.position = a.position + share * (b.position - a.position);
  point.floor = between(a.floor, b.floor);
  point.heading = between(a.heading, b.heading);
  return point;
}

} // namespace pcl::indoor
