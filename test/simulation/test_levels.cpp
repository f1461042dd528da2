/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "closed_shell.h"

#include <pcl/simulation/furniture.h>
#include <pcl/simulation/trajectory.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl::indoor;

const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

// One room, 0 ... 8 and 0 ... 6 m between its walls.
std::string
roomPlan(const std::string& keys, const std::string& more = "")
{
  return R"({"name": "", "wall_thickness": 0.2, "storeys": [
    {"name": "", "elevation": 0, "ceiling_height": 3.0, "rooms": [{"name": "room",
     "polygon": [[-0.1, -0.1], [8.1, -0.1], [8.1, 6.1], [-0.1, 6.1]] )" +
         keys + "}]" + more + "}]}";
}

// Heights of the ceiling over random places, and that nothing gets out.
template <typename Height>
void
expectCeiling(const Building& building, Height height)
{
  const Prober probe(building);
  RandomDraw draw(7);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d at(draw.uniform(0.01, 7.99), draw.uniform(0.01, 5.99));
    const double expected = height(at);
    if (expected < 0.05)
      continue;
    const double z = expected * draw.uniform(0.1, 0.9);
    EXPECT_NEAR(probe.distance({at.x(), at.y(), z}, up), expected - z, rounding)
        << at.transpose();
    EXPECT_NEAR(building.rooms[0].ceiling.heightAt(at), expected, 1e-9);
    probe.expectClosed({at.x(), at.y(), z}, 50, draw);
  }
}

TEST(Roof, AGableComesDownToTheFloor)
{
  const double t = std::tan(40 * radians);
  for (const double knee : {0.0, 0.4, 1.0}) {
    const auto building =
        buildText(roomPlan(R"(, "ceiling": {"ridge": [[0, 3], [8, 3]], "height": )" +
                           std::to_string(knee + 3 * t + 1e-6) + R"(, "pitch": 40})"));
    expectCeiling(building, [&](const Eigen::Vector2d& p) {
      return building.rooms[0].ceiling.planes[0].height - t * std::abs(p.y() - 3);
    });
    EXPECT_NEAR(shellVolume(building, 1), 8 * (6 * knee + 9 * t), 1e-3);
  }
}

TEST(Roof, TheLowestOfSeveralPlanesCounts)
{
  // A mono-pitch roof with a level ceiling below its upper part.
  const auto building = buildText(roomPlan(
      R"(, "ceiling": [{"height": 0.2, "at": [0, 0], "slope": [0.6, 0]}, 2.6])"));
  expectCeiling(building, [](const Eigen::Vector2d& p) {
    return std::min(2.6, 0.2 + 0.6 * p.x());
  });
  EXPECT_NEAR(shellVolume(building, 1), 6 * (4 * 1.4 + 4 * 2.6), 1e-3);
}

TEST(Roof, ADividingWallReachesUpToIt)
{
  const auto building = buildText(R"({"name": "", "wall_thickness": 0.2, "storeys": [
    {"name": "", "elevation": 5, "ceiling": {"ridge": [[0, 3], [8, 3]], "height": 3.2,
      "pitch": 45}, "rooms": [
      {"name": "a", "polygon": [[-0.1, -0.1], [4, -0.1], [4, 6.1], [-0.1, 6.1]]},
      {"name": "b", "polygon": [[4, -0.1], [8.1, -0.1], [8.1, 6.1], [4, 6.1]]}]}]})");
  const Prober probe(building);
  RandomDraw draw(4);
  for (int i = 0; i < 1000; ++i) {
    const double y = draw.uniform(0.01, 5.99);
    const double z = 5 + draw.uniform(0.01, 0.99) * (3.2 - std::abs(y - 3));
    EXPECT_NEAR(probe.distance({1, y, z}, {1, 0, 0}), 2.9, rounding);
    EXPECT_EQ(probe.room({1, y, z}, randomDirection(draw)), 1u);
    EXPECT_EQ(probe.room({6, y, z}, randomDirection(draw)), 2u);
  }
}

TEST(Vault, IsRoundToTheWidthOfItsFacets)
{
  const auto building = buildText(roomPlan(
      R"(, "ceiling": {"vault": [[0, 3], [8, 3]], "height": 4.5, "radius": 3.3})"));
  const Prober probe(building);
  const double flat =
      3.3 * (1 - std::cos(3.75 * radians)); // of a chord over 7.5 degrees
  RandomDraw draw(2);
  double most = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d at(draw.uniform(0.01, 7.99), draw.uniform(0.01, 5.99));
    const double round = 4.5 - 3.3 + std::sqrt(3.3 * 3.3 - std::pow(at.y() - 3, 2));
    const Eigen::Vector3d ray =
        Eigen::Vector3d(0, at.y() - 3, round - 1.2).normalized(); // along the radius
    const double gap = 3.3 - probe.distance({at.x(), 3, 1.2}, ray);
    EXPECT_GT(gap, -rounding);
    EXPECT_LT(gap, flat + rounding);
    most = std::max(most, gap);
    probe.expectClosed({at.x(), at.y(), 1.0}, 20, draw);
  }
  EXPECT_GT(most, 0.9 * flat);
}

TEST(CeilingParts, StepUpAndDown)
{
  const auto building = buildText(roomPlan(R"(, "ceiling_parts": [
    {"polygon": [[-1, -1], [2, -1], [2, 7], [-1, 7]], "ceiling": 2.4},
    {"polygon": [[2, 1], [5, 1], [5, 4], [2, 4]], "ceiling": 3.6},
    {"polygon": [[5, 2], [7, 1], [7, 5]], "ceiling": 2.0}])"));
  const auto height = [](const Eigen::Vector2d& p) {
    const bool hanging = p.x() > 5 && p.x() < 7 && p.y() > 2 - (p.x() - 5) / 2 &&
                         p.y() < 2 + 1.5 * (p.x() - 5);
    return p.x() < 2                             ? 2.4
           : p.x() < 5 && p.y() > 1 && p.y() < 4 ? 3.6
           : hanging                             ? 2.0
                                                 : 3.0;
  };
  expectCeiling(building, height);
  EXPECT_NEAR(
      shellVolume(building, 1), 8 * 6 * 3.0 - 0.6 * 2 * 6 + 0.6 * 9 - 1.0 * 4, 1e-3);
  for (const auto& t : building.triangles)
    EXPECT_LE(std::max({t.a.z(), t.b.z(), t.c.z()}), 3.6f + 1e-5f);
  // The step between the parts of 2.4 and 3.6 m faces the higher part.
  const Prober probe(building);
  EXPECT_NEAR(probe.distance({4, 2, 2.8}, {-1, 0, 0}), 2.0, rounding);
  EXPECT_EQ(probe.category({4, 2, 2.8}, {-1, 0, 0}), "ceiling");
  EXPECT_NEAR(probe.distance({4, 2, 2.2}, {-1, 0, 0}), 4.0, rounding);
}

TEST(CeilingParts, RandomRoomsAreClosed)
{
  RandomDraw draw(9);
  for (int trial = 0; trial < 40; ++trial) {
    const auto number = [&](double low, double high) {
      return std::to_string(draw.uniform(low, high));
    };
    const auto plane = [&] {
      return R"({"height": )" + number(2.2, 3.5) + R"(, "at": [4, 3], "slope": [)" +
             number(-0.2, 0.2) + ", " + number(-0.2, 0.2) + "]}";
    };
    const auto corner = [&](double x, double y) {
      return "[" + number(x - 0.4, x + 0.4) + ", " + number(y - 0.4, y + 0.4) + "]";
    };
    const auto part = [&](double x) {
      return R"({"polygon": [)" + corner(x, 1) + "," + corner(x + 2, 1) + "," +
             corner(x + 2, 5.8) + "," + corner(x, 5.8) + R"(], "ceiling": [)" +
             plane() + "," + plane() + "]}";
    };
    const auto building = buildText(roomPlan(R"(, "ceiling": [)" + plane() + "," +
                                             plane() + R"(], "ceiling_parts": [)" +
                                             part(0.5) + "," + part(5) + "]"));
    const Prober probe(building);
    for (int i = 0; i < 100; ++i) {
      const Eigen::Vector2d at(draw.uniform(0.01, 7.99), draw.uniform(0.01, 5.99));
      const double height = building.rooms[0].ceiling.heightAt(at);
      EXPECT_NEAR(probe.distance({at.x(), at.y(), 0.5}, up), height - 0.5, 1e-4);
      probe.expectClosed({at.x(), at.y(), 0.5}, 50, draw);
    }
  }
}

const std::string two_storeys = R"({"name": "", "wall_thickness": 0.2, "storeys": [
  {"name": "low", "elevation": 0, "ceiling_height": 2.6, "rooms": [{"name": "hall",
    "polygon": [[-0.1, -0.1], [8.1, -0.1], [8.1, 6.1], [-0.1, 6.1]]}],
   "furniture": [{"class": "stairs", "turn": "half", "at": [2.05, 4.4],
    "size": [2.1, 3.0, 4.0], "room": "landing"}]},
  {"name": "high", "elevation": 3, "ceiling_height": 2.6, "rooms": [{"name": "landing",
    "polygon": [[-0.1, -0.1], [8.1, -0.1], [8.1, 6.1], [-0.1, 6.1]]}],
   "wells": [{"polygon": [[1, 2.9], [3.1, 2.9], [3.1, 5.9], [1, 5.9]]}]}]})";

TEST(Wells, JoinTwoStoreys)
{
  const auto building = buildText(two_storeys);
  const Prober probe(building);
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  EXPECT_NEAR(probe.distance({3.5, 4, 4.5}, -up), 1.5, rounding);
  EXPECT_NEAR(probe.distance({3.5, 4, 1.0}, up), 1.6, rounding);
  EXPECT_NEAR(probe.distance({3.105, 5.0, 1.0}, up), 1.6, rounding);
  EXPECT_NEAR(probe.distance({3.095, 5.89, 1.4}, up), 4.2, rounding);
  EXPECT_EQ(probe.room({3.095, 5.89, 1.4}, up), 2u);
  // The edge of the slab: its lower half belongs below, its upper half above.
  EXPECT_NEAR(probe.distance({2.9, 3.0, 2.7}, x), 0.2, rounding);
  EXPECT_EQ(probe.room({3.09, 3.0, 2.75}, x), 1u);
  EXPECT_EQ(probe.room({3.09, 3.0, 2.85}, x), 2u);
  RandomDraw draw(6);
  for (const auto& from : planTrajectory(building, {}))
    probe.expectClosed(from, 3000, draw);
}

TEST(Wells, StairsBelongToTheRoomThatThePlanSays)
{
  const auto building = buildText(two_storeys);
  ASSERT_EQ(building.objects.size(), 1u);
  EXPECT_EQ(building.objects[0].room, 2u);
  EXPECT_EQ(building.objects[0].stands_in, 1u);
  for (const auto& surface : building.surfaces)
    if (surface.labels.object == 1) {
      EXPECT_EQ(surface.labels.room, 2u);
    }
  for (const auto& p : planTrajectory(building, {})) // nobody walks into them or falls
    EXPECT_FALSE(contains({{1, 2.9}, {3.1, 2.9}, {3.1, 5.9}, {1, 5.9}}, p.head<2>()))
        << p.transpose();
}

TEST(HalfTurnStairs, ClimbOnTheRightAndEndOnTheLeft)
{
  const auto model = makeHalfTurnStairs({2.0, 3.4, 3.8});
  const Eigen::AlignedBox3f box(Eigen::Vector3f(-1.0f, -1.7f, 0.0f).array() - 1e-5f,
                                Eigen::Vector3f(1.0f, 1.7f, 3.8f).array() + 1e-5f);
  Building building;
  for (const auto& part : model.parts)
    for (const auto& t : part.triangles) {
      for (const auto& p : {t.a, t.b, t.c})
        EXPECT_TRUE(box.contains(p)) << part.name << " " << p.transpose();
      building.triangles.push_back(t);
    }
  const Prober probe(building);
  const auto height = [&](double x, double y) {
    return 5 - probe.distance({x, y, 5}, -up);
  };
  const double rise = 2.8 / 16;
  EXPECT_NEAR(height(0.5, 1.65), rise, rounding);      // the first step, right in front
  EXPECT_NEAR(height(0.5, -1.3), 8 * rise, rounding);  // the landing along the rear
  EXPECT_NEAR(height(-0.5, -1.3), 8 * rise, rounding); // from one side to the other
  EXPECT_NEAR(height(-0.5, 1.65), 2.8, rounding);      // the last step, left in front
  double last = 0;
  for (double y = 1.65; y > -1.6; y -= 0.1) { // up and up
    EXPECT_GE(height(0.5, y), last - rounding);
    EXPECT_LE(height(0.5, y), last + rise + rounding);
    last = height(0.5, y);
  }
}

TEST(Platforms, RampsAndSlabsLieAtTheirHeight)
{
  const auto building = buildText(roomPlan("", R"(, "platforms": [
    {"polygon": [[1, 1], [6, 1], [6, 2.5], [1, 2.5]],
     "height": {"height": 0, "at": [1, 1], "slope": [0.2, 0]}},
    {"polygon": [[2, 4], [8, 4], [8, 6], [2, 6]], "height": 1.0, "thickness": 0.25}])"));
  const Prober probe(building);
  RandomDraw draw(8);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d at(draw.uniform(0.01, 7.99), draw.uniform(0.01, 5.99));
    const bool ramp = at.x() > 1 && at.x() < 6 && at.y() > 1 && at.y() < 2.5;
    const bool slab = at.x() > 2 && at.y() > 4;
    const double expected = ramp ? 0.2 * (at.x() - 1) : slab ? 1.0 : 0.0;
    EXPECT_NEAR(2.5 - probe.distance({at.x(), at.y(), 2.5}, -up), expected, rounding);
    EXPECT_EQ(probe.category({at.x(), at.y(), 2.5}, -up), "floor");
    EXPECT_EQ(probe.room({at.x(), at.y(), 2.5}, -up), 1u);
    if (slab) {
      EXPECT_NEAR(probe.distance({at.x(), at.y(), 0.1}, up), 0.65, rounding);
      EXPECT_EQ(probe.category({at.x(), at.y(), 0.1}, up), "ceiling");
    }
  }
  EXPECT_EQ(probe.category({7, 2, 0.5}, {-1, 0, 0}), "wall"); // the ramp's high end
  EXPECT_NEAR(probe.distance({7, 2, 0.5}, {-1, 0, 0}), 1.0, rounding);
  probe.expectClosed({0.5, 3, 1.5}, 20000, draw);
  // The sensor is carried over them.
  int on_slab = 0, on_ramp = 0;
  for (const auto& p : planTrajectory(building, {})) {
    const bool ramp = p.x() > 1 && p.x() < 6 && p.y() > 1 && p.y() < 2.5;
    on_ramp += ramp;
    on_slab += p.x() > 2 && p.y() > 4;
    if (p.x() > 2 && p.y() > 4) {
      EXPECT_NEAR(p.z(), 2.5, 1e-9);
    }
    if (ramp) {
      EXPECT_NEAR(p.z(), 1.5 + 0.2 * (p.x() - 1), 1e-9);
    }
  }
  EXPECT_GT(on_slab, 0);
  EXPECT_GT(on_ramp, 0);
}

TEST(Arcs, RoundWallsLieOnTheirCircle)
{
  const auto plan = parsePlan(R"({"name": "", "wall_thickness": 0.2, "storeys": [
    {"name": "", "elevation": 0, "ceiling_height": 3.0, "rooms": [
     {"name": "round", "polygon": [[3, 0], {"around": [0, 0], "sides": 16}, [-3, 0],
       {"around": [0, 0], "sides": 8}]},
     {"name": "niche", "polygon": [[3, 0], [6, 0], [6, 6], [-6, 6], [-6, 0], [-3, 0],
       {"around": [0, 0], "sides": 16, "turn": "right"}]}]}]})",
                              "test");
  const auto& round = plan.storeys[0].rooms[0].polygon;
  ASSERT_EQ(round.size(), 24u);
  for (const auto& p : round)
    EXPECT_NEAR(p.norm(), 3.0, 1e-9);
  EXPECT_NEAR(signedArea(round),
              0.5 * 9 * (16 * std::sin(M_PI / 16) + 8 * std::sin(M_PI / 8)),
              1e-9);
  const auto& niche = plan.storeys[0].rooms[1].polygon;
  ASSERT_EQ(niche.size(), 6u + 15u);
  EXPECT_NEAR(signedArea(niche), 72 - 0.5 * 9 * 16 * std::sin(M_PI / 16), 1e-9);
  const auto most = parsePlan(R"({"name": "", "wall_thickness": 0.2, "storeys": [
    {"name": "", "elevation": 0, "ceiling_height": 3.0, "rooms": [{"name": "most",
     "polygon": [[3, 0], {"around": [0, 0], "sides": 12, "turn": "right"}, [0, 3]]}]}]})",
                              "test");
  EXPECT_NEAR(
      signedArea(most.storeys[0].rooms[0].polygon), // three quarters to the right
      0.5 * 9 * (12 * std::sin(M_PI / 8) + 1),
      1e-9);
  const auto building = buildBuilding(plan);
  RandomDraw draw(3);
  const Prober probe(building);
  for (int i = 0; i < 200; ++i) {
    EXPECT_EQ(probe.room({0.3, 0.2, 1}, randomDirection(draw)), 1u);
    EXPECT_EQ(probe.room({4.5, 4.5, 1}, randomDirection(draw)), 2u);
  }
  probe.expectClosed({4.5, 4.5, 1}, 20000, draw);
}

TEST(Plans, HouseAndLandmarkAreClosed)
{
  RandomDraw draw(5);
  for (const char* name : {"/house.json", "/landmark.json"}) {
    const auto building = buildBuilding(readPlan(std::string(PCL_INDOOR_PLANS) + name));
    const Prober probe(building);
    for (const auto& from : planTrajectory(building, {}))
      probe.expectClosed(from, 500, draw);
  }
}

} // namespace
