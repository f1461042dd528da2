/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/scene/describe_building.h>
#include <pcl/scene/scene_file.h>

#include "files/cloud_writer.h"
#include "support/folder_test.h"
#include "support/synthetic_scenes.h"

#include <pcl/conversions.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>

using namespace pcl;
using namespace pcl::indoor;

namespace {

class DescribeBuilding : public indoor::test::FolderTest {
protected:
  /** Two rooms with a table and a cabinet, in a file. */
  std::string
  twoRooms(const std::string& name = "rooms.pcd") const
  {
    PointCloud<PointXYZ> cloud;
    for (const auto& point : indoor::test::twoRooms().points)
      cloud.emplace_back(point.x(), point.y(), point.z());
    PCLPointCloud2 bytes;
    toPCLPointCloud2(cloud, bytes);
    tool::saveCloud(path(name), bytes);
    return path(name);
  }

  static SceneOptions
  withoutClasses()
  {
    SceneOptions options;
    options.model = "none";
    return options;
  }

  static std::string
  problemOf(const Scan& scan, const SceneOptions& options)
  {
    try {
      describeBuilding(scan, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

} // namespace

TEST_F(DescribeBuilding, FindsRoomsAndTheirObjects)
{
  const auto scan = loadScan(twoRooms());
  const auto scene = describeBuilding(scan, withoutClasses());
  EXPECT_EQ(scene.rooms.size(), 2u);
  EXPECT_EQ(scene.openings.size(), 1u);
  EXPECT_EQ(scene.counts.all, scan.pointCount());
  EXPECT_EQ(scene.room_of_point.size(), scan.pointCount());
  EXPECT_EQ(scene.object_of_point.size(), scan.pointCount());
  EXPECT_TRUE(scene.classes.names.empty());
  for (std::uint32_t room = 1; room <= 2; ++room) // the table, the cabinet
    EXPECT_TRUE(std::any_of(
        scene.objects.begin(), scene.objects.end(), [&](const SceneObject& object) {
          return object.room == room && object.structure == 0;
        }));
  EXPECT_EQ(scene.frame.metres_per_unit, 1.0); // what was to be found was found
  EXPECT_EQ(scene.report.up_axis, Eigen::Vector3f::UnitZ());
}

TEST_F(DescribeBuilding, FindsTheWallBetweenTheRoomsWithItsDoor)
{
  const auto file = twoRooms("rooms.ply"); // not compressed
  ScanOptions in_parts;
  in_parts.points_at_once = 20000;
  auto options = withoutClasses();
  options.work_folder = path("");
  for (const auto& scan : {loadScan(file), loadScan(file, in_parts)}) {
    const auto model = describeBuilding(scan, options).model;
    const auto is_between = [](const ModelWall& wall) {
      return wall.rooms == std::vector<std::uint32_t>{1, 2} && wall.thickness > 0.0;
    };
    EXPECT_TRUE(std::any_of(model.walls.begin(), model.walls.end(), is_between))
        << scan.isReadInParts();
    ASSERT_GE(model.openings.size(), 1u) << scan.isReadInParts();
    const auto& door = model.openings[0];
    EXPECT_EQ(door.kind, ModelOpeningKind::Door);
    EXPECT_TRUE(door.is_open);
    ASSERT_LT(door.wall, model.walls.size());
    EXPECT_TRUE(is_between(model.walls[door.wall])) << scan.isReadInParts();
  }
}

TEST_F(DescribeBuilding, GivesTheSameForAnyNumberOfThreadsAndTwice)
{
  const auto scan = loadScan(twoRooms());
  auto options = withoutClasses();
  options.threads = 1;
  const auto text = sceneText(describeBuilding(scan, options));
  options.threads = 3;
  EXPECT_EQ(sceneText(describeBuilding(scan, options)), text);
}

TEST_F(DescribeBuilding, TakesAFunctionInPlaceOfTheModel)
{
  SceneOptions options;
  options.naming.classes = {"low", "high"};
  options.naming.classify = [](const std::vector<ClassifierObject>& objects) {
    std::vector<Classification> classes(objects.size());
    for (std::size_t i = 0; i < objects.size(); ++i) {
      float lower = INFINITY, upper = -INFINITY;
      for (const auto& point : objects[i].points) {
        lower = std::min(lower, point.position.z());
        upper = std::max(upper, point.position.z());
      }
      const bool is_high = upper - lower > 1.2f;
      classes[i].probabilities = {is_high ? 0.0f : 1.0f, is_high ? 1.0f : 0.0f};
    }
    return classes;
  };
  const auto scene = describeBuilding(loadScan(twoRooms()), options);
  EXPECT_EQ(scene.classes.names, (std::vector<std::string>{"none", "low", "high"}));
  ASSERT_EQ(scene.classes.objects.size(), scene.objects.size());
  std::set<std::uint32_t> categories;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const auto category = scene.classes.objects[i].category;
    EXPECT_EQ(category == 0, scene.objects[i].structure != 0) << i;
    categories.insert(category);
  }
  EXPECT_EQ(categories.size(), 3u);
}

TEST_F(DescribeBuilding, OfAScanThatIsReadInPartsFindsTheSameRooms)
{
  const auto file = twoRooms("rooms.ply"); // not compressed
  ScanOptions in_parts;
  in_parts.points_at_once = 20000;
  auto options = withoutClasses();
  options.work_folder = path("");
  const auto scan = loadScan(file, in_parts);
  ASSERT_TRUE(scan.isReadInParts());
  const auto scene = describeBuilding(scan, options);
  const auto whole = describeBuilding(loadScan(file), options);
  EXPECT_EQ(scene.rooms.size(), whole.rooms.size());
  EXPECT_EQ(scene.counts.all, whole.counts.all);
  EXPECT_EQ(scene.object_of_point.size(), scene.room_of_point.size());
  EXPECT_LT(scene.object_of_point.size(), whole.object_of_point.size());
  EXPECT_GT(
      *std::max_element(scene.object_of_point.begin(), scene.object_of_point.end()),
      0u);
  for (const auto& entry : std::filesystem::directory_iterator(path(""))) // all removed
    EXPECT_EQ(entry.path().filename(), "rooms.ply");
  // a second time, from the same open file
  EXPECT_EQ(sceneText(describeBuilding(scan, options)), sceneText(scene));
}

TEST_F(DescribeBuilding, WritesWhatItFound)
{
  const auto scene = describeBuilding(loadScan(twoRooms()), withoutClasses());
  saveScene(path("scene.json"), scene);
  EXPECT_EQ(indoor::test::bytesOf(path("scene.json")), sceneText(scene));
  const auto json = nlohmann::json::parse(sceneText(scene));
  EXPECT_EQ(json["input"], "rooms.pcd");
  EXPECT_EQ(json["rooms"].size(), 2u);
  EXPECT_EQ(json["settings"]["model"], "none");
  EXPECT_EQ(json["settings"]["unit"], "m");
  EXPECT_EQ(json["objects"].size(), scene.objects.size());
  EXPECT_THROW(saveScene(path("no/scene.json"), scene), InputError);
}

TEST_F(DescribeBuilding, RefusesOptionsThatAreNone)
{
  const auto scan = loadScan(twoRooms());
  auto options = withoutClasses();
  options.scan.unit = "yd";
  EXPECT_EQ(problemOf(scan, options), "unit: 'yd' is none");
  options = withoutClasses();
  options.scan.up = "0,0,0";
  EXPECT_NE(problemOf(scan, options).find("has no direction"), std::string::npos);
  options = withoutClasses();
  options.preparation.normals = "guess";
  EXPECT_EQ(problemOf(scan, options), "normals: 'guess' is none");
  options = withoutClasses();
  options.voxel_resolution = 0.1;
  options.seed_resolution = 0.05;
  EXPECT_NE(problemOf(scan, options).find("is less than"), std::string::npos);
}
