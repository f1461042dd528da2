/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/carried_path.h>
#include <pcl/simulation/random_plan.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace {

using namespace pcl::indoor;

Building
bundled(const std::string& name)
{
  return buildBuilding(readPlan(std::string(PCL_INDOOR_PLANS) + "/" + name), name);
}

// Three rooms in a row; the door to the last one is closed.
Building
rowOfRooms()
{
  return buildBuilding(parsePlan(R"({"name": "row", "wall_thickness": 0.2, "storeys": [
    {"name": "", "elevation": 0, "ceiling_height": 2.5, "rooms": [
     {"name": "a", "polygon": [[0, 0], [5, 0], [5, 4], [0, 4]]},
     {"name": "b", "polygon": [[5, 0], [9, 0], [9, 4], [5, 4]]},
     {"name": "c", "polygon": [[9, 0], [12, 0], [12, 4], [9, 4]]}],
     "passages": [{"at": [5, 2], "width": 0.9}],
     "doors": [{"at": [9, 2], "width": 0.9, "angle": 0}]}]})",
                                 "row"));
}

std::set<std::uint32_t>
enteredRooms(const Building& building, const std::vector<CarriedPath>& paths)
{
  std::set<std::uint32_t> rooms;
  for (const auto& path : paths)
    for (const auto& point : path)
      for (std::uint32_t r = 1; r <= building.rooms.size(); ++r)
        if (std::abs(building.rooms[r - 1].floor - point.floor) < 0.1 &&
            contains(building.rooms[r - 1].polygon, point.position.head<2>()))
          rooms.insert(r);
  return rooms;
}

// Steps of a walk: time and way go on, and nothing is on the way.
void
expectWalk(const Building& building, const CarriedPath& path, double speed)
{
  const RayTracer tracer(building.triangles);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const PathPoint &a = path[i - 1], &b = path[i];
    ASSERT_NEAR(b.time - a.time, 0.1, 1e-9);
    ASSERT_GE(b.way, a.way);
    ASSERT_LE(b.way - a.way, 0.1 * speed + 1e-9);
    const Eigen::Vector3f step = (b.position - a.position).cast<float>();
    // A rounded point beside an exact one may be a few steps off.
    ASSERT_LT(step.norm(), 0.35f) << "no leaps at " << a.position.transpose();
    if (step.norm() > 0) {
      ASSERT_LT(tracer.trace(a.position.cast<float>(), step, 0.0f, 1.0f).triangle, 0)
          << "through something at " << a.position.transpose();
    }
  }
}

TEST(CarriedPath, GoesThroughOpenDoorsAndComesBack)
{
  const auto building = rowOfRooms();
  PathOptions options;
  const auto paths = planPaths(building, options);
  ASSERT_EQ(paths.size(), 1u);
  const auto& path = paths.front();
  EXPECT_EQ(enteredRooms(building, paths), (std::set<std::uint32_t>{1, 2}));
  expectWalk(building, path, options.speed);
  EXPECT_LT((path.front().position - path.back().position).norm(), 1e-9);
  for (const auto& point : path) {
    EXPECT_NEAR(point.position.z(), options.sensor_height, 1e-9);
    EXPECT_EQ(point.floor, 0.0);
  }
}

TEST(CarriedPath, WalksThroughFurnishedBuildings)
{
  for (const double height : {0.6, 1.4}) {
    PathOptions options;
    options.sensor_height = height;
    for (const char* name : {"random:office:2", "random:home:1"}) {
      SCOPED_TRACE(name);
      const auto building = buildBuilding(*randomPlanNamed(name), name);
      for (const auto& path : planPaths(building, options))
        expectWalk(building, path, options.speed);
    }
    const auto house = bundled("house.json");
    const auto paths = planPaths(house, options);
    EXPECT_EQ(paths.size(), 4u) << "one for each storey";
    for (const auto& path : paths)
      expectWalk(house, path, options.speed);
  }
}

TEST(CarriedPath, EntersTheShareOfRoomsThatIsAskedFor)
{
  const auto building = buildBuilding(*randomPlanNamed("random:office:1"), "office");
  PathOptions options;
  const auto all = enteredRooms(building, planPaths(building, options));
  ASSERT_GE(all.size(), 5u);
  std::set<std::set<std::uint32_t>> choices;
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    options.seed = seed;
    options.entered = 0.5;
    const auto some = enteredRooms(building, planPaths(building, options));
    EXPECT_EQ(some.size(), (all.size() + 1) / 2) << "seed " << seed;
    for (const auto room : some)
      EXPECT_TRUE(all.count(room));
    choices.insert(some);
  }
  EXPECT_GT(choices.size(), 1u) << "seeds choose";
  options.entered = 0.0;
  EXPECT_EQ(enteredRooms(building, planPaths(building, options)).size(), 1u);
}

TEST(CarriedPath, LooksAroundAtEveryStop)
{
  const auto building = rowOfRooms();
  PathOptions options;
  const auto plain = planPaths(building, options).front();
  options.look_around = true;
  const auto around = planPaths(building, options).front();
  EXPECT_NEAR(plain.back().way, around.back().way, 1e-9);
  double turned = 0, standing = 0;
  for (std::size_t i = 1; i < around.size(); ++i) {
    const double turn = around[i].heading - around[i - 1].heading;
    EXPECT_LE(std::abs(turn), 0.1 * M_PI / 2 + 1e-9) << "90 degrees per second";
    if (around[i].way == around[i - 1].way) {
      turned += turn;
      standing += around[i].time - around[i - 1].time;
    }
  }
  const double turns = turned / (2 * M_PI);
  EXPECT_NEAR(turns, std::round(turns), 1e-6);
  EXPECT_GE(turns, 2.0) << "a stop in each room";
  EXPECT_NEAR(standing, around.back().time - plain.back().time, 1e-6);
}

TEST(CarriedPath, GoesStraightThroughGivenPositions)
{
  PathOptions options;
  options.speed = 1.0;
  options.sensor_height = 1.0;
  const auto path = pathThrough({{0, 0, 1.5}, {3, 0, 1.5}, {3, 4, 1.5}}, options);
  EXPECT_NEAR(path.back().time, 7.0, 1e-9);
  EXPECT_NEAR(path.back().way, 7.0, 1e-9);
  EXPECT_LT((placeAt(path, 1.25).position - Eigen::Vector3d(1.25, 0, 1.5)).norm(),
            1e-9);
  EXPECT_LT((placeAt(path, 5.05).position - Eigen::Vector3d(3, 2.05, 1.5)).norm(),
            1e-9);
  EXPECT_LT((placeAt(path, -1).position - Eigen::Vector3d(0, 0, 1.5)).norm(), 1e-9);
  EXPECT_LT((placeAt(path, 99).position - Eigen::Vector3d(3, 4, 1.5)).norm(), 1e-9);
  EXPECT_NEAR(placeAt(path, 1.0).floor, 0.5, 1e-9);
  EXPECT_NEAR(placeAt(path, 1.0).heading, 0.0, 1e-9);
  EXPECT_NEAR(placeAt(path, 6.5).heading, M_PI / 2, 1e-6);
  EXPECT_TRUE(pathThrough({}, options).empty());
  EXPECT_EQ(pathThrough({{1, 2, 3}}, options).size(), 1u);
}

TEST(CarriedPath, RefusesOptionsOutOfRange)
{
  const auto building = rowOfRooms();
  const auto refuses = [&](const auto& change) {
    PathOptions options;
    change(options);
    EXPECT_THROW(planPaths(building, options), pcl::BadArgumentException);
    EXPECT_THROW(pathThrough({{0, 0, 1}}, options), pcl::BadArgumentException);
  };
  refuses([](PathOptions& o) { o.speed = 0; });
  refuses([](PathOptions& o) { o.speed = 1e9; });
  refuses([](PathOptions& o) { o.speed = std::nan(""); });
  refuses([](PathOptions& o) { o.spacing = 0; });
  refuses([](PathOptions& o) { o.sensor_height = -1; });
  refuses([](PathOptions& o) { o.clearance = -1; });
  refuses([](PathOptions& o) { o.entered = 1.1; });
}

} // namespace
