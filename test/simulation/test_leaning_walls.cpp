/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "closed_shell.h"

#include <pcl/simulation/trajectory.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl::indoor;

// Inner faces: west 0 ... 4, east 4.2 ... 9.2, both 0 ... 3 and 0 ... 2.5 m high.
std::string
twoRooms(const std::string& lean, const std::string& openings = "")
{
  return R"({"name": "", "wall_thickness": 0.2, )" + lean + R"("storeys": [
    {"name": "", "elevation": 0, "ceiling_height": 2.5, "rooms": [
      {"name": "west", "polygon": [[-0.1, -0.1], [4.1, -0.1], [4.1, 3.1], [-0.1, 3.1]]},
      {"name": "east", "polygon": [[4.1, -0.1], [9.3, -0.1], [9.3, 3.1], [4.1, 3.1]]}]
    )" + openings +
         "}]}";
}

std::string
middleWall(double angle)
{
  return R"("leaning_walls": [{"from": [4.1, -0.1], "to": [4.1, 3.1], "angle": )" +
         std::to_string(angle) + "}], ";
}

std::string
whole(double angle, double towards)
{
  return R"("lean": {"angle": )" + std::to_string(angle) + R"(, "towards": )" +
         std::to_string(towards) + "}, ";
}

TEST(LeaningWalls, ARayMeetsAWallInItsPlane)
{
  for (const double angle : {-20.0, -5.0, 0.0, 5.0, 10.0, 20.0}) {
    const auto building = buildText(twoRooms(middleWall(angle)));
    const Prober probe(building);
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
    const double tangent = std::tan(angle * radians); // to the left of north: west
    for (double z = 0.05; z < 2.5; z += 0.1) {
      EXPECT_NEAR(probe.distance({1.5, 1.2, z}, x), 2.5 - z * tangent, rounding);
      EXPECT_NEAR(probe.distance({6.5, 1.2, z}, -x), 2.3 + z * tangent, rounding);
      EXPECT_NEAR(probe.distance({6.5, 1.2, z}, x), 2.7, rounding); // stands upright
    }
    const auto normal = probe.normal({1.5, 1.2, 1.0}, x);
    EXPECT_NEAR(std::asin(-normal.z()) / radians, angle, 1e-3);
  }
}

TEST(LeaningWalls, AWholeBuildingMovesWithItsHeight)
{
  for (const double angle : {5.0, 10.0, 20.0})
    for (const double towards : {0.0, 35.0, 90.0, 200.0}) {
      const auto building = buildText(twoRooms(whole(angle, towards)));
      const Prober probe(building);
      const double t = std::tan(angle * radians);
      const Eigen::Vector2d drift(t * std::cos(towards * radians),
                                  t * std::sin(towards * radians));
      for (double z = 0.1; z < 2.5; z += 0.2) {
        const Eigen::Vector3d from(2 + z * drift.x(), 1 + z * drift.y(), z);
        EXPECT_NEAR(probe.distance(from, {1, 0, 0}), 2.0, rounding);
        EXPECT_NEAR(probe.distance(from, {-1, 0, 0}), 2.0, rounding);
        EXPECT_NEAR(probe.distance(from, {0, 1, 0}), 2.0, rounding);
        EXPECT_NEAR(probe.distance(from, {0, -1, 0}), 1.0, rounding);
      }
      EXPECT_NEAR(shellVolume(building, 1), 4 * 3 * 2.5, 1e-4); // a shear keeps it
    }
}

TEST(LeaningWalls, ANamedWallDoesNotFollowTheBuilding)
{
  const auto building = buildText(twoRooms(whole(20, 0) + middleWall(10)));
  const Prober probe(building);
  const double z = 2.0, drift = z * std::tan(20 * radians);
  EXPECT_NEAR(
      probe.distance({2, 1, z}, {1, 0, 0}), 2.0 - z * std::tan(10 * radians), rounding);
  EXPECT_NEAR(probe.distance({2, 1, z}, {-1, 0, 0}), 2.0 - drift, rounding);
}

TEST(LeaningWalls, RoomsHaveTheirVolumeAndPointsTheirSide)
{
  for (const double angle : {-20.0, -10.0, 10.0, 20.0}) {
    const auto building = buildText(twoRooms(middleWall(angle)));
    const double tangent = std::tan(angle * radians);
    const double moved = 3 * tangent * 2.5 * 2.5 / 2;
    EXPECT_NEAR(shellVolume(building, 1), 4 * 3 * 2.5 - moved, 1e-4);
    EXPECT_NEAR(shellVolume(building, 2), 5 * 3 * 2.5 + moved, 1e-4);
    const Prober probe(building);
    RandomDraw draw(3);
    int sides[2] = {0, 0};
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector3d from(
          draw.uniform(3, 5), draw.uniform(0.01, 2.99), draw.uniform(0.01, 2.49));
      const double off = from.x() + from.z() * tangent - 4.1; // from the middle line
      if (std::abs(off) < 0.101)
        continue;
      EXPECT_EQ(probe.room(from, randomDirection(draw)), off < 0 ? 1u : 2u);
      ++sides[off < 0 ? 0 : 1];
    }
    EXPECT_GT(std::min(sides[0], sides[1]), 300);
  }
}

TEST(LeaningWalls, WallsThatLeanApartMeetInTheirCorners)
{
  // Two neighbouring walls lean outwards: the corner moves along both.
  const auto building = buildText(
      twoRooms(R"("leaning_walls": [{"from": [-0.1, 3.1], "to": [-0.1, -0.1], "angle":
               -10}, {"from": [4.1, 3.1], "to": [-0.1, 3.1], "angle": -20}], )"));
  const double a = std::tan(10 * radians), b = std::tan(20 * radians), h = 2.5;
  // The integral of (4 + a z) (3 + b z) over the height.
  EXPECT_NEAR(shellVolume(building, 1),
              12 * h + (4 * b + 3 * a) * h * h / 2 + a * b * h * h * h / 3,
              1e-4);
  RandomDraw draw(1);
  Prober(building).expectClosed({2, 1.5, 1.2}, 20000, draw);
}

TEST(LeaningWalls, OpeningsLeanWithTheirWall)
{
  const std::string openings =
      R"(, "passages": [{"at": [4.1, 1.5], "width": 1.0, "height": 2.2}],
      "windows": [{"at": [9.3, 1.5], "width": 1.0, "height": 1.0, "sill": 1.0}])";
  for (const double angle : {-20.0, 10.0, 20.0}) {
    const auto building = buildText(twoRooms(middleWall(angle), openings));
    const Prober probe(building);
    for (const double z : {0.1, 1.2, 2.15}) {
      EXPECT_EQ(probe.room({1, 1.02, z}, {1, 0, 0}), 2u);
      EXPECT_EQ(probe.room({1, 1.98, z}, {1, 0, 0}), 2u);
      EXPECT_EQ(probe.room({1, 0.98, z}, {1, 0, 0}), 1u);
      EXPECT_EQ(probe.room({1, 2.02, z}, {1, 0, 0}), 1u);
    }
    EXPECT_EQ(probe.room({1, 1.5, 2.25}, {1, 0, 0}), 1u); // the lintel
    RandomDraw draw(2);
    probe.expectClosed({2, 1, 1}, 5000, draw);
    probe.expectClosed({4.1 - std::tan(angle * radians), 1.5, 1.0}, 5000, draw);
  }
  // Upwards along the leaning side of a passage, half a centimetre in front of it.
  const auto building = buildText(
      twoRooms(whole(20, 90), R"(, "passages": [{"at": [4.1, 1.5], "width": 1.0}])"));
  const double t = std::tan(20 * radians);
  const Eigen::Vector3d up(0, t, 1);
  const Eigen::Vector3d foot(4.05, 1.995, 0.05);
  EXPECT_NEAR(Prober(building).distance(foot + 0.05 * t * Eigen::Vector3d::UnitY(), up),
              2.0,
              1e-4);
}

TEST(LeaningWalls, PanesAndDoorsLean)
{
  const std::string openings =
      R"(, "doors": [{"at": [4.1, 1.0], "width": 0.9}],
      "windows": [{"at": [4.1, 2.2], "width": 0.8, "height": 1.0, "sill": 1.0}])";
  const auto building = buildText(twoRooms(middleWall(20), openings));
  const Prober probe(building);
  for (const auto& from :
       {Eigen::Vector3d(1, 1.0, 0.6), Eigen::Vector3d(1, 2.3, 1.6)}) {
    const auto hit = probe.hit(from, {1, 0, 0});
    ASSERT_GE(hit.triangle, 0);
    const auto& labels = building.surfaces[hit.triangle].labels;
    EXPECT_GT(labels.object, 0u);
    EXPECT_EQ(labels.room, 1u);
    EXPECT_NEAR(probe.normal(from, {1, 0, 0}).z(), -std::sin(20 * radians), 1e-4);
  }
}

TEST(LeaningWalls, AngleZeroIsUpright)
{
  auto plan = readPlan(PCL_INDOOR_PLANS "/leaning.json");
  setLean(plan, 0.0);
  auto upright = plan;
  upright.leaning_walls.clear();
  const auto a = buildBuilding(plan), b = buildBuilding(upright);
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    EXPECT_EQ(a.triangles[i].a, b.triangles[i].a);
    EXPECT_EQ(a.triangles[i].b, b.triangles[i].b);
    EXPECT_EQ(a.triangles[i].c, b.triangles[i].c);
  }
}

// All plans of the office floor with leaning walls.
std::vector<Building>
leaningFloors()
{
  std::vector<Building> buildings;
  for (const double angle : {0.0, 5.0, 10.0, 20.0}) {
    auto plan = readPlan(PCL_INDOOR_PLANS "/leaning.json");
    setLean(plan, angle * radians);
    buildings.push_back(buildBuilding(plan));
    setLean(plan, {angle * radians, 35 * radians});
    buildings.push_back(buildBuilding(plan));
  }
  return buildings;
}

TEST(LeaningWalls, TheFloorIsClosedAtAllAngles)
{
  RandomDraw draw(5);
  for (const auto& building : leaningFloors()) {
    EXPECT_EQ(building.rooms.size(), 16u);
    const Prober probe(building);
    for (const auto& from : planTrajectory(building, {}))
      probe.expectClosed(from, 500, draw);
  }
}

TEST(LeaningWalls, FurnitureStandsOffTheWalls)
{
  for (const auto& building : leaningFloors())
    for (const auto& object : building.objects) {
      if (object.category == "door" || object.category == "window")
        continue;
      const auto& room = building.rooms[object.room - 1];
      const Eigen::Rotation2Dd turn(object.rotation);
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
          for (const double h : {0.0, 1.0}) {
            const double z = object.position.z() + h * object.size.z();
            const Eigen::Vector2d corner =
                object.position.head<2>() +
                turn * Eigen::Vector2d(x * object.size.x(), y * object.size.y());
            const Eigen::Vector2d drawn = corner - z * building.lean;
            const auto walls = room.polygonAt(z);
            EXPECT_TRUE(contains(walls, drawn) ||
                        distanceToBoundary(walls, drawn) <= 0.051)
                << object.category << " at " << object.position.transpose();
          }
    }
}

} // namespace
