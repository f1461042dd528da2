/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/building.h>
#include <pcl/simulation/range_sensor.h>
#include <pcl/simulation/scene_description.h>
#include <pcl/simulation/trajectory.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace {

using namespace pcl::indoor;

const Building&
office()
{
  static const Building building =
      buildBuilding(readPlan(PCL_INDOOR_PLANS "/office.json"));
  return building;
}

const Building&
flat()
{
  static const Building building =
      buildBuilding(readPlan(PCL_INDOOR_PLANS "/flat.json"));
  return building;
}

TEST(Building, TheOfficeIsLargeEnough)
{
  const auto& building = office();
  EXPECT_GE(building.rooms.size(), 14u);
  std::size_t furniture = 0;
  std::set<std::string> categories;
  for (const auto& object : building.objects) {
    categories.insert(object.category);
    furniture += object.category != "door" && object.category != "window" ? 1 : 0;
  }
  EXPECT_GE(furniture, 80u);
  EXPECT_GE(categories.size(), 10u);
  std::set<std::uint32_t> storeys;
  bool sloped = false, double_height = false;
  for (const auto& room : building.rooms) {
    storeys.insert(room.storey);
    sloped |= room.ceiling.planes[0].slope.norm() > 0.1;
    double_height |= room.ceiling.planes[0].height > 5.0;
  }
  EXPECT_EQ(storeys.size(), 2u);
  EXPECT_TRUE(sloped);
  EXPECT_TRUE(double_height);
}

TEST(Building, TheFlatHasThreeRooms) { EXPECT_EQ(flat().rooms.size(), 3u); }

TEST(Building, EveryTriangleHasConsistentLabels)
{
  for (const auto* building : {&office(), &flat()}) {
    ASSERT_EQ(building->triangles.size(), building->surfaces.size());
    for (const auto& surface : building->surfaces) {
      const auto& labels = surface.labels;
      ASSERT_LT(labels.category, building->categories.size());
      ASSERT_LE(labels.room, building->rooms.size());
      EXPECT_EQ(labels.object == 0, surface.kind == SurfaceKind::Shell);
      if (labels.object == 0)
        continue;
      const auto& object = building->objects.at(labels.object - 1);
      EXPECT_EQ(building->categories[labels.category], object.category);
      EXPECT_GE(labels.part, object.first_part);
      EXPECT_LT(labels.part, object.first_part + object.part_names.size());
    }
  }
}

TEST(Building, PartsAreNumberedThroughTheBuilding)
{
  std::uint32_t next = 1;
  for (const auto& object : office().objects) {
    EXPECT_EQ(object.first_part, next);
    next += static_cast<std::uint32_t>(object.part_names.size());
  }
}

TEST(Building, ShellsFaceTheirRoom)
{
  const auto& building = flat();
  for (std::size_t i = 0; i < building.triangles.size(); ++i) {
    const auto& surface = building.surfaces[i];
    const auto& t = building.triangles[i];
    if (surface.kind != SurfaceKind::Shell || surface.labels.room == 0)
      continue;
    const auto& room = building.rooms[surface.labels.room - 1];
    const Eigen::Vector3f normal = (t.b - t.a).cross(t.c - t.a).normalized();
    const Eigen::Vector3f middle = (t.a + t.b + t.c) / 3;
    const Eigen::Vector3d before = (middle + 0.05f * normal).cast<double>();
    // A step off any face of a shell leads into its room, or into a hole in its wall.
    const bool in_room =
        contains(room.polygon, before.head<2>()) && before.z() > room.floor &&
        before.z() < room.floor + room.ceiling.heightAt(before.head<2>());
    bool in_hole = false;
    for (const auto& object : building.objects)
      if (object.category == "door" || object.category == "window")
        in_hole |= (object.position.head<2>() - before.head<2>()).norm() <
                   object.size.x() / 2 + 0.12;
    EXPECT_TRUE(in_room || in_hole) << middle.transpose();
  }
}

TEST(Building, BothSidesOfAClosedDoorAndOfGlassBelongToTheirRooms)
{
  const auto building = buildBuilding(parsePlan(R"({"name": "", "wall_thickness": 0.2,
    "storeys": [{"name": "", "elevation": 0, "ceiling_height": 2.5, "rooms": [
      {"name": "left", "polygon": [[0, 0], [4, 0], [4, 6], [0, 6]]},
      {"name": "right", "polygon": [[4, 0], [9, 0], [9, 6], [4, 6]]}],
     "doors": [{"at": [4, 1], "width": 0.9}],
     "windows": [{"at": [4, 4], "width": 2, "height": 1.5, "sill": 0.6}]}]})",
                                                "glass"));
  std::map<std::string, int> seen;
  for (std::size_t i = 0; i < building.triangles.size(); ++i) {
    const auto& labels = building.surfaces[i].labels;
    const auto& t = building.triangles[i];
    const float middle = (t.a.x() + t.b.x() + t.c.x()) / 3;
    // What lies in the middle of the wall, or reaches through it, may belong to either.
    if (std::abs(middle - 4.0f) < 0.001f)
      continue;
    EXPECT_EQ(labels.room, middle < 4.0f ? 1u : 2u)
        << building.categories[labels.category] << " at x = " << middle;
    ++seen[building.categories[labels.category] + std::to_string(labels.room)];
    if (building.surfaces[i].kind == SurfaceKind::InteriorGlass) {
      EXPECT_GT((t.b - t.a).cross(t.c - t.a).x() * (middle - 4.0f), 0.0f); // outwards
      ++seen["glass" + std::to_string(labels.room)];
    }
  }
  for (const char* key : {"door1", "door2", "window1", "window2", "glass1", "glass2"})
    EXPECT_GT(seen[key], 0) << key;
}

// The footprint, a centimetre smaller all around so that neighbours may touch.
Polygon
footprint(const ObjectInfo& object)
{
  const Eigen::Rotation2Dd turn(object.rotation);
  const double x = object.size.x() / 2 - 0.01, y = object.size.y() / 2 - 0.01;
  Polygon polygon;
  for (const auto& corner : Polygon{{-x, -y}, {x, -y}, {x, y}, {-x, y}})
    polygon.push_back(object.position.head<2>() + turn * corner);
  return polygon;
}

TEST(Building, FurnitureStandsApart)
{
  // What is pushed under a table, stands on it or bears a beam is left out.
  const std::set<std::string> mixes{
      "chair", "office_chair", "monitor", "stool", "beam", "door", "window"};
  for (const auto* building : {&office(), &flat()})
    for (const auto& a : building->objects)
      for (const auto& b : building->objects) {
        const bool apart_in_height = a.position.z() >= b.position.z() + b.size.z() ||
                                     b.position.z() >= a.position.z() + a.size.z();
        if (&a >= &b || mixes.count(a.category) || mixes.count(b.category) ||
            apart_in_height)
          continue;
        EXPECT_FALSE(overlap(footprint(a), footprint(b)))
            << a.category << " at " << a.position.transpose() << " and " << b.category
            << " at " << b.position.transpose();
      }
}

TEST(Building, OpenDoorLeavesMeetNoFurniture)
{
  const auto& building = office();
  for (std::size_t i = 0; i < building.triangles.size(); ++i) {
    const auto& labels = building.surfaces[i].labels;
    if (labels.category != building.category("door"))
      continue;
    const auto& door = building.objects[labels.object - 1];
    if (door.part_names[labels.part - door.first_part] != "leaf")
      continue;
    const auto& t = building.triangles[i];
    for (const auto& object : building.objects)
      for (const auto& corner : {t.a, t.b, t.c, Eigen::Vector3f((t.a + t.b) / 2)})
        EXPECT_FALSE(object.room == labels.room && object.category != "door" &&
                     object.position.z() < corner.z() &&
                     corner.z() < object.position.z() + object.size.z() &&
                     contains(footprint(object), corner.head<2>().cast<double>()))
            << object.category << " at " << object.position.transpose()
            << " and the door at " << door.position.transpose();
  }
}

TEST(Trajectory, ReachesEveryRoomAndKeepsClear)
{
  for (const auto* building : {&office(), &flat()}) {
    const TrajectoryOptions options;
    const auto positions = planTrajectory(*building, options);
    for (const auto& room : building->rooms) {
      const auto inside = [&](const Eigen::Vector3d& p) {
        return contains(room.polygon, p.head<2>()) && p.z() > room.floor &&
               p.z() < room.floor + room.ceiling.heightAt(p.head<2>());
      };
      EXPECT_TRUE(std::any_of(positions.begin(), positions.end(), inside)) << room.name;
    }
    for (const auto& p : positions)
      for (const auto& object : building->objects)
        if (object.category == "column") {
          EXPECT_GT((object.position - p).head<2>().norm(), 0.35);
        }
  }
}

TEST(Trajectory, CloserSpacingGivesMorePositions)
{
  TrajectoryOptions options;
  const auto few = planTrajectory(flat(), options);
  options.spacing = 1.0;
  EXPECT_GT(planTrajectory(flat(), options).size(), few.size());
  options.spacing = 0.0;
  EXPECT_THROW(planTrajectory(flat(), options), pcl::BadArgumentException);
}

TEST(SceneDescription, NamesEveryNumber)
{
  const auto& building = office();
  const auto json = nlohmann::json::parse(describeScene(building, {{1, 2, 1.5}}));
  ASSERT_EQ(json["rooms"].size(), building.rooms.size());
  ASSERT_EQ(json["objects"].size(), building.objects.size());
  EXPECT_EQ(json["categories"], nlohmann::json(building.categories));
  EXPECT_EQ(json["trajectory"], nlohmann::json::parse("[[1.0, 2.0, 1.5]]"));
  for (std::size_t i = 0; i < building.rooms.size(); ++i) {
    EXPECT_EQ(json["rooms"][i]["number"], i + 1);
    EXPECT_EQ(json["rooms"][i]["name"], building.rooms[i].name);
    EXPECT_EQ(json["rooms"][i].value("kind", ""), building.rooms[i].kind);
    EXPECT_EQ(json["rooms"][i]["storey"], building.rooms[i].storey);
    EXPECT_EQ(json["rooms"][i]["polygon"].size(), building.rooms[i].polygon.size());
  }
  EXPECT_EQ(json["objects"][4]["category"], building.objects[4].category);
  EXPECT_EQ(json["objects"][4]["room"], building.objects[4].room);
}

} // namespace
