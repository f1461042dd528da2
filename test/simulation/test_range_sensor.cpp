/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "same_scan.h"

#include <pcl/simulation/random_draw.h>
#include <pcl/simulation/range_sensor.h>
#include <pcl/simulation/trajectory.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>

namespace {

using namespace pcl::indoor;
using pcl::indoor::test::same;

// A box 0 ... 4, 0 ... 3 and 0 ... 2.5 m, whose walls are as thin as they may be.
Building
emptyRoom()
{
  return buildBuilding(parsePlan(R"({"name": "box", "wall_thickness": 0.2, "storeys": [
    {"name": "", "elevation": 0, "ceiling_height": 2.5, "rooms": [{"name": "box",
     "polygon": [[-0.1, -0.1], [4.1, -0.1], [4.1, 3.1], [-0.1, 3.1]]}]}]})",
                                 "box"));
}

RangeSensorOptions
perfect(int rays)
{
  RangeSensorOptions options;
  options.rays_per_pose = rays;
  options.noise = options.drift = options.dropout = 0.0;
  options.grazing_exponent = 1e6; // no echo is lost
  options.glass_echo = options.glass_ghost = 0.0;
  options.min_range = 0.0;
  return options;
}

const Eigen::Vector3d middle(1.5, 1.2, 1.1);

TEST(RangeSensor, APerfectScanOfABoxLiesOnItsFaces)
{
  const auto building = emptyRoom();
  const auto scan = scanBuilding(building, {middle}, perfect(20000));
  EXPECT_GE(scan.points.size(), 19990u); // a few run exactly along a face's edge
  std::map<std::uint32_t, int> seen;
  for (const auto& p : scan.points) {
    const float faces[6] = {p.x, 4 - p.x, p.y, 3 - p.y, p.z, 2.5f - p.z};
    const auto face = std::min_element(
        faces, faces + 6, [](float a, float b) { return std::abs(a) < std::abs(b); });
    ASSERT_NEAR(*face, 0.0f, 1e-4f);
    ASSERT_GT(*std::min_element(faces, faces + 6), -1e-4f);
    const char* expected = face == faces + 4   ? "floor"
                           : face == faces + 5 ? "ceiling"
                                               : "wall";
    const bool edge = std::count_if(faces, faces + 6, [](float d) {
                        return std::abs(d) < 1e-4f;
                      }) > 1;
    if (!edge) {
      EXPECT_EQ(building.categories[p.category], expected);
    }
    EXPECT_EQ(p.room, 1u);
    EXPECT_EQ(p.object, 0u);
    EXPECT_EQ(p.part, 0u);
    ++seen[p.category];
  }
  // The floor's share is its solid angle: the sum over its four corners of
  // atan(a b / (h sqrt(a^2 + b^2 + h^2))), divided by 4 pi.
  double solid_angle = 0;
  for (const double a : {middle.x(), 4 - middle.x()})
    for (const double b : {middle.y(), 3 - middle.y()})
      solid_angle += std::atan(
          a * b / (middle.z() * std::sqrt(a * a + b * b + middle.z() * middle.z())));
  const double share = static_cast<double>(seen[building.category("floor")]) / 20000;
  EXPECT_NEAR(
      share, solid_angle / (4 * M_PI), 0.003); // even rays: few cells at the rim
}

TEST(RangeSensor, NoiseHasItsStandardDeviationAlongTheRay)
{
  const auto building = emptyRoom();
  auto options = perfect(40000);
  const auto exact = scanBuilding(building, {middle}, options);
  options.noise = 0.02;
  // Other draws follow, but turn and shift of the rays come first: the same rays.
  const auto noisy = scanBuilding(building, {middle}, options);
  ASSERT_EQ(exact.points.size(), noisy.points.size());
  double sum = 0, sum2 = 0;
  for (std::size_t i = 0; i < exact.points.size(); ++i) {
    const auto &p = exact.points[i], &q = noisy.points[i];
    const Eigen::Vector3d ray = Eigen::Vector3d(p.x, p.y, p.z) - middle;
    const Eigen::Vector3d moved = Eigen::Vector3d(q.x, q.y, q.z) - middle;
    const double error = moved.dot(ray.normalized()) - ray.norm();
    ASSERT_LT((moved - moved.dot(ray.normalized()) * ray.normalized()).norm(), 1e-5);
    sum += error;
    sum2 += error * error;
  }
  const double n = static_cast<double>(exact.points.size());
  EXPECT_NEAR(sum / n, 0.0, 4 * 0.02 / std::sqrt(n)); // 4 standard errors
  EXPECT_NEAR(std::sqrt(sum2 / n), 0.02, 4 * 0.02 / std::sqrt(2 * n));
}

TEST(RangeSensor, ABroadBeamMixesWhatIsBesideAnEdge)
{
  // A board, its front 0.4 m before the wall at x = 4 m.
  const auto building =
      buildBuilding(parsePlan(R"({"name": "box", "wall_thickness": 0.2, "storeys": [
    {"name": "", "elevation": 0, "ceiling_height": 2.5, "rooms": [{"name": "box",
     "polygon": [[-0.1, -0.1], [4.1, -0.1], [4.1, 3.1], [-0.1, 3.1]]}],
     "furniture": [{"class": "cabinet", "at": [3.7, 1.2],
      "size": [0.6, 0.2, 1.2], "rotation": 90}]}]})",
                              "box"));
  auto options = perfect(200000);
  const auto exact = scanBuilding(building, {middle}, options);
  options.beam = 0.004;
  const auto mixed = scanBuilding(building, {middle}, options);
  ASSERT_EQ(exact.points.size(), mixed.points.size()) << "the same rays";
  std::size_t between = 0;
  for (std::size_t i = 0; i < exact.points.size(); ++i) {
    const auto &p = exact.points[i], &q = mixed.points[i];
    EXPECT_EQ(p.object, q.object) << "labels are those of the middle of the beam";
    const Eigen::Vector3d ray = Eigen::Vector3d(p.x, p.y, p.z) - middle;
    const Eigen::Vector3d other = Eigen::Vector3d(q.x, q.y, q.z) - middle;
    EXPECT_NEAR(ray.normalized().cross(other).norm(), 0, 1e-5) << "on the same ray";
    const double moved = other.norm() - ray.norm();
    EXPECT_LT(std::abs(moved), 0.25) << "not half way to what is 0.5 m apart";
    if (std::abs(moved) < 0.05)
      continue;
    ++between;
    // In the air between the board and the wall.
    EXPECT_GT(q.x, 3.6f);
    EXPECT_LT(q.x, 4.0);
    EXPECT_EQ(p.object == 1, moved > 0) << "towards the other";
  }
  EXPECT_GE(between, 20u);
  EXPECT_LE(between, 400u) << "most of the scan is no edge";
}

TEST(RangeSensor, DriftMovesAllPointsOfAPoseTogether)
{
  const auto building = emptyRoom();
  auto options = perfect(500);
  const std::vector<Eigen::Vector3d> positions(400, middle);
  const auto exact = scanBuilding(building, positions, options);
  options.drift = 0.05;
  const auto moved = scanBuilding(building, positions, options);
  ASSERT_EQ(exact.points.size(), moved.points.size());
  // The mean over a pose's points of the displacement is near its error of position.
  std::vector<Eigen::Vector3d> shift(positions.size(), Eigen::Vector3d::Zero());
  std::vector<int> count(positions.size(), 0);
  for (std::size_t i = 0; i < exact.points.size(); ++i) {
    const auto &p = exact.points[i], &q = moved.points[i];
    shift[exact.poses[i]] += Eigen::Vector3d(q.x - p.x, q.y - p.y, q.z - p.z);
    ++count[exact.poses[i]];
  }
  Eigen::Vector3d sum2 = Eigen::Vector3d::Zero();
  for (std::size_t pose = 0; pose < shift.size(); ++pose)
    sum2 += (shift[pose] / count[pose]).cwiseAbs2();
  const Eigen::Vector3d deviation =
      (sum2 / static_cast<double>(shift.size())).cwiseSqrt();
  // 400 draws: 3.5 % standard error; the heading adds a little in x and y.
  EXPECT_NEAR(deviation.x(), 0.05, 0.01);
  EXPECT_NEAR(deviation.y(), 0.05, 0.01);
  EXPECT_NEAR(deviation.z(), 0.025, 0.005); // half in height
}

TEST(RangeSensor, DropoutGrowsTowardsGrazingAngles)
{
  RangeSensorOptions options;
  options.dropout = 0.1;
  options.grazing_exponent = 4.0;
  EXPECT_DOUBLE_EQ(echoProbability(1.0, options), 0.9);
  EXPECT_DOUBLE_EQ(echoProbability(-1.0, options), 0.9);
  EXPECT_DOUBLE_EQ(echoProbability(0.0, options), 0.0);
  EXPECT_DOUBLE_EQ(echoProbability(0.5, options), 0.9 * (1.0 - 1.0 / 16));
  for (double c = 0.0; c < 0.95; c += 0.05)
    EXPECT_LT(echoProbability(c, options), echoProbability(c + 0.05, options));
}

TEST(RangeSensor, EchoesAreLostAsOftenAsTheModelSays)
{
  const auto building = emptyRoom();
  auto options = perfect(60000);
  const auto all = scanBuilding(building, {middle}, options);
  options.dropout = 0.3;
  options.grazing_exponent = 3.0;
  const auto some = scanBuilding(building, {middle}, options);
  double expected = 0;
  for (const auto& p : all.points) {
    const Eigen::Vector3d ray = Eigen::Vector3d(p.x, p.y, p.z) - middle;
    const double off[3] = {
        std::min(p.x, 4 - p.x), std::min(p.y, 3 - p.y), std::min(p.z, 2.5f - p.z)};
    const auto axis = std::min_element(off, off + 3) - off;
    expected += echoProbability(ray.normalized()[axis], options);
  }
  // A sum of 60000 independent draws: standard deviation below 123.
  EXPECT_NEAR(static_cast<double>(some.points.size()), expected, 500.0);
}

TEST(RangeSensor, SurfacesOutOfRangeGiveNoEcho)
{
  auto options = perfect(20000);
  options.min_range = 1.15; // beyond the nearest floor at 1.1 m
  options.max_range = 2.0;
  const auto scan = scanBuilding(emptyRoom(), {middle}, options);
  ASSERT_GT(scan.points.size(), 1000u);
  ASSERT_LT(scan.points.size(), 19000u);
  for (const auto& p : scan.points) {
    const double range = (Eigen::Vector3d(p.x, p.y, p.z) - middle).norm();
    EXPECT_GE(range, 1.15 - 1e-4);
    EXPECT_LE(range, 2.0 + 1e-4);
  }
}

Building
roomWithWindow()
{
  return buildBuilding(parsePlan(R"({"name": "box", "wall_thickness": 0.2, "storeys": [
    {"name": "", "elevation": 0, "ceiling_height": 2.5, "rooms": [{"name": "box",
     "polygon": [[-0.1, -0.1], [4.1, -0.1], [4.1, 3.1], [-0.1, 3.1]]}],
     "windows": [{"at": [2, -0.1], "width": 3.0, "height": 2.0, "sill": 0.3}]}]})",
                                 "box"));
}

TEST(RangeSensor, GlassMirrorsSomeRaysAndReturnsSome)
{
  const auto building = roomWithWindow();
  auto options = perfect(60000);
  const auto clear = scanBuilding(building, {middle}, options);
  const auto ghost = building.category("ghost"), window = building.category("window");
  const auto countOf = [](const SimulatedScan& scan, std::uint32_t category) {
    return static_cast<double>(
        std::count_if(scan.points.begin(), scan.points.end(), [&](const auto& p) {
          return p.category == category;
        }));
  };
  EXPECT_EQ(countOf(clear, ghost), 0.0);
  const double frame = countOf(clear, window);
  const double lost = 60000.0 - static_cast<double>(clear.points.size()); // outside
  ASSERT_GT(lost, 3000.0);
  options.glass_echo = 0.2;
  options.glass_ghost = 0.3;
  const auto scan = scanBuilding(building, {middle}, options);
  const double deviation = 5 * std::sqrt(lost * 0.25); // five standard deviations
  EXPECT_NEAR(countOf(scan, window) - frame, 0.2 * lost, deviation);
  EXPECT_NEAR(countOf(scan, ghost), 0.3 * lost, deviation);
  // The pane stands at y = -0.096: what is mirrored there lies in the mirrored room.
  for (const auto& p : scan.points)
    if (p.category == ghost) {
      EXPECT_LT(p.y, -0.096f + 1e-4f);
      EXPECT_GT(p.y, -3.2f - 1e-3f); // the far wall at y = 3, mirrored
      EXPECT_EQ(p.room, 0u);
      EXPECT_EQ(p.object, 0u);
    }
}

TEST(RangeSensor, FurnitureHidesWhatIsBehind)
{
  const auto plan = readPlan(PCL_INDOOR_PLANS "/flat.json");
  const auto building = buildBuilding(plan);
  const auto positions = planTrajectory(building, {});
  const auto scan = scanBuilding(building, positions, perfect(3000));
  RayTracer tracer(building.triangles);
  for (std::size_t i = 0; i < scan.points.size(); i += 7) {
    const auto& p = scan.points[i];
    if (building.categories[p.category] == "window")
      continue; // seen through or beside glass
    const Eigen::Vector3f from = positions[scan.poses[i]].cast<float>();
    const Eigen::Vector3f ray = Eigen::Vector3f(p.x, p.y, p.z) - from;
    const auto hit = tracer.trace(from, ray, 0.0f, 0.999f);
    EXPECT_TRUE(hit.triangle < 0 || building.surfaces[hit.triangle].isGlass());
  }
}

TEST(RangeSensor, EveryObjectOfTheFlatIsSeen)
{
  const auto building = buildBuilding(readPlan(PCL_INDOOR_PLANS "/flat.json"));
  const auto scan = scanBuilding(building, planTrajectory(building, {}), {});
  std::vector<int> count(building.objects.size() + 1, 0);
  for (const auto& p : scan.points)
    ++count.at(p.object);
  for (std::size_t i = 1; i < count.size(); ++i)
    EXPECT_GT(count[i], 50) << building.objects[i - 1].category;
}

TEST(RangeSensor, PointsCarryTheRoomTheyLieIn)
{
  const auto building = buildBuilding(readPlan(PCL_INDOOR_PLANS "/flat.json"));
  auto options = perfect(20000);
  const auto scan = scanBuilding(building, planTrajectory(building, {}), options);
  for (const auto& p : scan.points) {
    const Eigen::Vector2d at(p.x, p.y);
    for (std::size_t r = 0; r < building.rooms.size(); ++r)
      if (contains(building.rooms[r].polygon, at) &&
          distanceToBoundary(building.rooms[r].polygon, at) > 1e-3) {
        ASSERT_EQ(p.room, r + 1) << at.transpose();
      }
  }
}

TEST(RangeSensor, ThreadsAndRunsGiveTheSameScan)
{
  const auto building = buildBuilding(readPlan(PCL_INDOOR_PLANS "/flat.json"));
  const auto positions = planTrajectory(building, {});
  RangeSensorOptions options;
  options.rays_per_pose = 2000;
  options.threads = 1;
  const auto one = scanBuilding(building, positions, options);
  EXPECT_TRUE(same(one, scanBuilding(building, positions, options)));
  options.threads = 2;
  EXPECT_TRUE(same(one, scanBuilding(building, positions, options)));
  options.threads = 8;
  EXPECT_TRUE(same(one, scanBuilding(building, positions, options)));
  options.seed = 2;
  EXPECT_FALSE(same(one, scanBuilding(building, positions, options)));
}

TEST(RangeSensor, WhatTheProgressThrowsArrivesAtTheCaller)
{
  const auto building = emptyRoom();
  auto options = perfect(100);
  const std::vector<Eigen::Vector3d> positions(20, middle);
  for (const int threads : {1, 4}) {
    options.threads = threads;
    std::size_t told = 0;
    options.progress = [&](std::size_t done, std::size_t all) {
      EXPECT_EQ(done, ++told);
      EXPECT_EQ(all, positions.size());
    };
    scanBuilding(building, positions, options);
    EXPECT_EQ(told, positions.size());
    options.progress = [](std::size_t done, std::size_t) {
      if (done == 3)
        throw std::runtime_error("stop");
    };
    EXPECT_THROW(scanBuilding(building, positions, options), std::runtime_error);
  }
}

TEST(RangeSensor, ThinningKeepsOnePointPerCube)
{
  RandomDraw draw(5);
  SimulatedScan scan;
  for (int i = 0; i < 5000; ++i) {
    PointXYZScene p;
    p.x = static_cast<float>(draw.uniform(-1, 1));
    p.y = static_cast<float>(draw.uniform(-1, 1));
    p.z = static_cast<float>(draw.uniform(-1, 1));
    p.part = static_cast<std::uint32_t>(i);
    scan.points.push_back(p);
    scan.poses.push_back(static_cast<std::uint32_t>(i / 100));
  }
  std::map<std::array<int, 3>, std::uint32_t> first;
  for (const auto& p : scan.points)
    first.insert({{static_cast<int>(std::floor(p.x / 0.25)),
                   static_cast<int>(std::floor(p.y / 0.25)),
                   static_cast<int>(std::floor(p.z / 0.25))},
                  p.part});
  const auto all = scan;
  thinScan(scan, 0.25);
  EXPECT_EQ(scan.points.size(), first.size());
  ASSERT_EQ(scan.poses.size(), scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const auto& p = scan.points[i];
    EXPECT_EQ(p.part / 100, scan.poses[i]);
    EXPECT_EQ(p.x, all.points[p.part].x);
    EXPECT_TRUE(std::any_of(
        first.begin(), first.end(), [&](const auto& f) { return f.second == p.part; }));
  }
  auto whole = all;
  thinScan(whole, 0.0);
  EXPECT_TRUE(same(whole, all));
  EXPECT_THROW(thinScan(scan, -1.0), pcl::BadArgumentException);
  EXPECT_THROW(thinScan(scan, std::nan("")), pcl::BadArgumentException);
}

TEST(RangeSensor, RefusesImpossibleOptions)
{
  const auto building = emptyRoom();
  const auto refused = [&](auto change) {
    RangeSensorOptions options;
    change(options);
    EXPECT_THROW(scanBuilding(building, {middle}, options), pcl::BadArgumentException);
  };
  refused([](auto& o) { o.rays_per_pose = 0; });
  refused([](auto& o) { o.min_range = -1; });
  refused([](auto& o) { o.max_range = o.min_range; });
  refused([](auto& o) { o.noise = -0.1; });
  refused([](auto& o) { o.noise = std::nan(""); });
  refused([](auto& o) { o.drift = -0.1; });
  refused([](auto& o) { o.beam = -0.001; });
  refused([](auto& o) { o.beam = 0.2; });
  refused([](auto& o) { o.dropout = 1.1; });
  refused([](auto& o) { o.grazing_exponent = 0; });
  refused([](auto& o) { o.glass_echo = -0.1; });
  refused([](auto& o) { o.glass_ghost = 0.99; });
  refused([](auto& o) { o.threads = -1; });
  EXPECT_TRUE(scanBuilding(building, {}, {}).points.empty());
}

} // namespace
