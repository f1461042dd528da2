/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "same_scan.h"

#include <pcl/simulation/carried_lidar.h>
#include <pcl/simulation/random_plan.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace {

using namespace pcl::indoor;
using pcl::indoor::test::same;

// A hall of 20 x 6 x 3 m with its corner at the origin.
Building
hall()
{
  const auto building =
      buildBuilding(parsePlan(R"({"name": "hall", "wall_thickness": 0.2,
    "storeys": [{"name": "", "elevation": 0, "ceiling_height": 3, "rooms": [
     {"name": "hall", "polygon": [[-0.1, -0.1], [20.1, -0.1], [20.1, 6.1], [-0.1, 6.1]]}
    ]}]})",
                              "hall"));
  return building;
}

// No errors, no people, and a turn takes no time, so that a frame has one pose.
CarriedLidarOptions
perfectLidar(LidarModel model)
{
  auto options = lidarOptions(model);
  options.noise = options.drift = options.dropout = 0.0;
  options.grazing_exponent = 1e6; // no echo is lost
  options.glass_echo = options.glass_ghost = 0.0;
  options.people = 0;
  options.turn_rate = 1e9;
  return options;
}

CarriedPath
straightOn()
{
  PathOptions options;
  options.sensor_height = 1.0;
  return pathThrough({{2, 3, 1}, {18, 3, 1}}, options);
}

// From the sensor to a point of a scan, in the sensor's axes.
Eigen::Vector3d
seenFrom(const Eigen::Isometry3d& pose, const PointXYZScene& point)
{
  return pose.inverse() * Eigen::Vector3d(point.x, point.y, point.z);
}

TEST(CarriedLidar, RingsLieOnCones)
{
  const auto building = hall();
  const std::vector<CarriedPath> paths{straightOn()};
  for (const auto model : {LidarModel::Spinning, LidarModel::Walk}) {
    auto options = perfectLidar(model);
    options.rings = 7;
    options.lowest_ring = -0.3;
    options.highest_ring = 0.6;
    options.steps_per_turn = 100;
    const auto frames = framesOn(paths, options);
    const auto scan = scanAlong(building, paths, options);
    std::vector<std::size_t> seen(7, 0);
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const auto pose = sensorPose(paths[0], frames[scan.poses[i]].time, options);
      const auto ray = seenFrom(pose, scan.points[i]);
      const double elevation = std::atan2(ray.z(), ray.head<2>().norm());
      const double ring = (elevation + 0.3) / 0.15;
      ASSERT_NEAR(ring, std::round(ring), 1e-3); // floats of 20 m: 1e-6 m
      ++seen.at(static_cast<std::size_t>(std::lround(ring)));
    }
    const std::size_t most = 100 * frames.size();
    for (const auto count : seen) {
      EXPECT_LE(count, most);
      EXPECT_GT(count, most / 2) << "the carrier hides less than half";
    }
    if (model == LidarModel::Spinning) {
      EXPECT_EQ(scan.points.size(), 7 * most) << "nothing hides anything";
    }
  }
}

TEST(CarriedLidar, OfTheRobotIsLevelAndOfTheHandIsNot)
{
  const auto path = straightOn();
  double highest = 0, lowest = 10, most_tilt = 0;
  for (double time = 0; time < path.back().time; time += 0.05) {
    const auto robot = sensorPose(path, time, perfectLidar(LidarModel::Spinning));
    EXPECT_LT((robot.translation() - placeAt(path, time).position).norm(), 1e-12);
    EXPECT_NEAR(robot.linear()(2, 2), 1.0, 1e-12);
    const auto hand = sensorPose(path, time, perfectLidar(LidarModel::Walk));
    const Eigen::Vector3d off = hand.translation() - placeAt(path, time).position;
    EXPECT_LT(off.norm(), 0.25);
    highest = std::max(highest, off.z());
    lowest = std::min(lowest, off.z());
    most_tilt = std::max(most_tilt, std::acos(std::min(1.0, hand.linear()(2, 2))));
  }
  EXPECT_GT(highest - lowest, 0.1) << "metres: bobs, and is lifted";
  EXPECT_GT(most_tilt, 0.1) << "radians";
  EXPECT_LT(most_tilt, 0.7) << "radians";
}

TEST(CarriedLidar, ARosetteFillsItsFieldAndDoesNotRepeat)
{
  const auto building = hall();
  auto options = perfectLidar(LidarModel::SolidState);
  options.turn_rate = 10; // the pattern goes on with time
  options.rays_per_frame = 2000;
  PathOptions stand;
  stand.sensor_height = 1.0;
  auto path = pathThrough({{2, 3, 1}}, stand);
  for (int k = 1; k <= 20; ++k) { // stands still for two seconds
    path.push_back(path.front());
    path.back().time = 0.1 * k;
  }
  const std::vector<CarriedPath> paths{path};
  const auto scan = scanAlong(building, paths, options);
  EXPECT_EQ(scan.ray_count, 2 * 2000u);
  double widest = 0, highest = 0;
  std::set<std::pair<long, long>> first, second; // directions, to a milliradian
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    // Each frame has 2000 rays and loses none: the i-th is the i-th.
    const double time =
        scan.poses[i] + static_cast<double>(i % 2000) / (2000 * options.turn_rate);
    const auto ray = seenFrom(sensorPose(path, time, options), scan.points[i]);
    const double azimuth = std::atan2(ray.y(), ray.x());
    const double elevation = std::atan2(ray.z(), ray.head<2>().norm());
    const double u = azimuth / (options.field_width / 2),
                 v = elevation / (options.field_height / 2);
    ASSERT_LE(u * u + v * v, 1.0 + 1e-4);
    widest = std::max(widest, std::abs(u));
    highest = std::max(highest, std::abs(v));
    (scan.poses[i] == 0 ? first : second)
        .insert({std::lround(1000 * azimuth), std::lround(1000 * elevation)});
  }
  ASSERT_EQ(scan.points.size(), 4000u);
  EXPECT_GT(widest, 0.95);
  EXPECT_GT(highest, 0.95);
  std::size_t again = 0;
  for (const auto& direction : second)
    again += first.count(direction);
  EXPECT_LT(again, second.size() / 10) << "another frame looks elsewhere";
}

TEST(CarriedLidar, DriftIsABridgeThatClosesAtTheEnd)
{
  const auto building = hall();
  const std::vector<CarriedPath> paths{straightOn()};
  auto options = perfectLidar(LidarModel::Spinning);
  options.rings = 1;
  options.lowest_ring = options.highest_ring = 0.0;
  options.steps_per_turn = 4;
  const auto frames = framesOn(paths, options);
  const double length = paths[0].back().way;
  constexpr int draws = 400;
  std::vector<double> squares(frames.size(), 0.0);
  for (int seed = 1; seed <= draws; ++seed) {
    options.seed = static_cast<std::uint32_t>(seed);
    options.drift = 0.0;
    const auto exact = scanAlong(building, paths, options);
    options.drift = 0.1;
    const auto moved = scanAlong(building, paths, options);
    ASSERT_EQ(exact.points.size(), 4 * frames.size());
    ASSERT_EQ(moved.points.size(), exact.points.size());
    for (std::size_t f = 0; f < frames.size(); ++f) {
      double height = 0; // the error of height has no part of the heading's
      for (std::size_t k = 4 * f; k < 4 * f + 4; ++k)
        height += (moved.points[k].z - exact.points[k].z) / 4;
      squares[f] += height * height / draws;
    }
  }
  EXPECT_NEAR(squares.front(), 0.0, 1e-12) << "none at the start";
  for (std::size_t f = 1; f < frames.size(); ++f) {
    const double way = placeAt(paths[0], frames[f].time).way;
    // A Brownian bridge: half of 0.1 m after 10 m in height.
    const double expected = 0.05 * 0.05 * way / 10 * (1 - way / length);
    EXPECT_NEAR(squares[f], expected, 4 * expected * std::sqrt(2.0 / draws) + 1e-6)
        << way << " m"; // four standard errors of a variance
  }
  const auto last = placeAt(paths[0], frames.back().time).way;
  EXPECT_LT(squares.back(), 0.3 * squares[frames.size() / 2]) << last << " m";
}

TEST(CarriedLidar, LabelsAreThoseOfTheFirstSurfaceOnTheWay)
{
  const auto building = buildBuilding(*randomPlanNamed("random:office:1"), "office");
  const RayTracer tracer(building.triangles);
  for (const auto model :
       {LidarModel::Spinning, LidarModel::SolidState, LidarModel::Walk}) {
    const auto paths = planPaths(building, pathOptions(model));
    auto options = perfectLidar(model);
    options.glass_echo = 1.0; // a pane is a surface like others
    options.steps_per_turn = 60;
    options.rays_per_frame = 1000;
    options.frame_rate = 0.2;
    const auto frames = framesOn(paths, options);
    const auto scan = scanAlong(building, paths, options);
    ASSERT_GT(scan.points.size(), 5000u);
    std::size_t differ = 0;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const auto& point = scan.points[i];
      const auto& frame = frames[scan.poses[i]];
      const Eigen::Vector3d from =
          sensorPose(paths[frame.path], frame.time, options).translation();
      const Eigen::Vector3d way = Eigen::Vector3d(point.x, point.y, point.z) - from;
      const auto hit = tracer.trace(from.cast<float>(),
                                    way.normalized().cast<float>(),
                                    static_cast<float>(options.min_range));
      if (hit.triangle < 0 || std::abs(hit.distance - way.norm()) > 1e-3) {
        ++differ; // rays along an edge: a rounding decides
        continue;
      }
      const auto& labels = building.surfaces[hit.triangle].labels;
      const bool equal = labels.room == point.room && labels.object == point.object &&
                         labels.part == point.part && labels.category == point.category;
      differ += equal ? 0 : 1;
    }
    EXPECT_LT(differ, scan.points.size() / 500);
  }
}

TEST(CarriedLidar, PeopleLeaveTrails)
{
  const auto building = hall();
  const auto person = building.category("person");
  const std::vector<CarriedPath> paths{straightOn()};
  auto options = perfectLidar(LidarModel::Spinning);
  const auto countPeople = [&](const SimulatedScan& scan) {
    return std::count_if(scan.points.begin(), scan.points.end(), [&](const auto& p) {
      return p.category == person;
    });
  };
  EXPECT_EQ(countPeople(scanAlong(building, paths, options)), 0);
  std::ptrdiff_t fewer = 0;
  for (const int people : {1, 3}) {
    options.people = people;
    const auto scan = scanAlong(building, paths, options);
    EXPECT_GT(countPeople(scan), fewer);
    fewer = countPeople(scan);
    double from = 20, to = 0;
    for (const auto& p : scan.points)
      if (p.category == person) {
        EXPECT_LE(std::abs(p.y - 3), 0.2 + 1e-5) << "a body beside the path";
        EXPECT_LE(p.z, 1.74f + 1e-5f);
        EXPECT_EQ(p.room, 1u);
        EXPECT_EQ(p.object, 0u);
        EXPECT_EQ(p.part, 0u);
        from = std::min<double>(from, p.x);
        to = std::max<double>(to, p.x);
      }
    EXPECT_GT(to - from, 8.0) << "along the path";
  }
}

TEST(CarriedLidar, WhoCarriesItHidesWhatIsBehind)
{
  const auto building = hall();
  const std::vector<CarriedPath> paths{straightOn()};
  for (const auto model : {LidarModel::Spinning, LidarModel::Walk}) {
    auto options = perfectLidar(model);
    const auto frames = framesOn(paths, options);
    const auto scan = scanAlong(building, paths, options);
    std::size_t behind = 0;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const auto place = placeAt(paths[0], frames[scan.poses[i]].time).position;
      const double ahead = scan.points[i].x - place.x(),
                   left = scan.points[i].y - place.y();
      behind += ahead < -1 && std::abs(left) < -0.1 * ahead ? 1 : 0;
    }
    if (model == LidarModel::Walk) {
      EXPECT_EQ(behind, 0u);
    }
    else {
      EXPECT_GT(behind, 1000u);
    }
  }
}

TEST(CarriedLidar, IsTheSameForAnyNumberOfThreadsAndOneSeed)
{
  const auto building = buildBuilding(*randomPlanNamed("random:home:1"), "home");
  for (const auto model :
       {LidarModel::Spinning, LidarModel::SolidState, LidarModel::Walk}) {
    const auto paths = planPaths(building, pathOptions(model));
    auto options = lidarOptions(model);
    options.steps_per_turn = 100;
    options.rays_per_frame = 1000;
    options.threads = 1;
    const auto one = scanAlong(building, paths, options);
    EXPECT_GT(one.points.size(), 1000u);
    for (const int threads : {2, 8}) {
      options.threads = threads;
      EXPECT_TRUE(same(one, scanAlong(building, paths, options)));
    }
    options.seed = 2;
    EXPECT_FALSE(same(one, scanAlong(building, paths, options)));
  }
}

TEST(CarriedLidar, RefusesOptionsOutOfRange)
{
  const auto building = hall();
  const std::vector<CarriedPath> paths{straightOn()};
  const auto refuses = [&](const auto& change) {
    auto options = lidarOptions(LidarModel::Spinning);
    change(options);
    EXPECT_THROW(scanAlong(building, paths, options), pcl::BadArgumentException);
  };
  using Options = CarriedLidarOptions;
  refuses([](Options& o) { o.rings = 0; });
  refuses([](Options& o) { o.steps_per_turn = 0; });
  refuses([](Options& o) { o.rays_per_frame = 0; });
  refuses([](Options& o) { o.lowest_ring = 1.0; });
  refuses([](Options& o) { o.highest_ring = 2.0; });
  refuses([](Options& o) { o.field_width = 0.0; });
  refuses([](Options& o) { o.field_height = 4.0; });
  refuses([](Options& o) { o.turn_rate = 0.0; });
  refuses([](Options& o) { o.frame_rate = std::nan(""); });
  refuses([](Options& o) { o.frame_rate = 1e12; });
  refuses([](Options& o) { o.drift = -1.0; });
  refuses([](Options& o) { o.people = 11; });
  refuses([](Options& o) { o.noise = -1.0; });
  const auto options = lidarOptions(LidarModel::Spinning);
  EXPECT_THROW(scanAlong(building, {CarriedPath()}, options),
               pcl::BadArgumentException);
  EXPECT_TRUE(scanAlong(building, {}, options).points.empty());
}

} // namespace
