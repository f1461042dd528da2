/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Runs pcl_indoor_pipeline and pcl_room_segmentation on scans that lack something and
// looks at what is said, on stderr and in the JSON files.
#include "support/folder_test.h"
#include "support/labelled_cloud.h"
#include "support/room_with_chairs.h"
#include "support/run_tool.h"
#include "support/synthetic_scenes.h"

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

using pcl::indoor::test::bytesOf;
using Json = nlohmann::json;

class OverviewResults : public pcl::indoor::test::FolderTest {
protected:
  /** Saves those points of two furnished rooms that are not taken away. */
  template <typename Predicate>
  std::string
  save(const std::string& name, const Predicate& is_gone, double shift = 0.0) const
  {
    auto scene = pcl::indoor::test::twoRooms();
    scene.removeIf(is_gone);
    pcl::PointCloud<pcl::PointXYZ> cloud;
    for (const auto& p : scene.points)
      cloud.emplace_back(static_cast<float>(p.x() + shift), p.y(), p.z());
    pcl::io::savePCDFileBinary(path(name), cloud);
    return path(name);
  }

  std::string
  saveAll(const std::string& name) const
  {
    return save(name, [](const auto&) { return false; });
  }

  int
  run(const std::string& tool, const std::string& arguments) const
  {
    return pcl::indoor::test::runTool(tool, arguments, path("out"), path("said"));
  }

  std::string
  said() const
  {
    return bytesOf(path("said"));
  }

  bool
  says(const std::string& text) const
  {
    return said().find(text) != std::string::npos;
  }

  Json
  jsonOf(const std::string& name) const
  {
    return Json::parse(bytesOf(path(name)));
  }
};

bool
isCeiling(const Eigen::Vector3f& p)
{
  return p.z() > 2.4f;
}

bool
isNoSlice(const Eigen::Vector3f& p)
{
  return p.z() < 1.0f || p.z() > 1.4f;
}

bool
has(const Json& lines, const std::string& text)
{
  for (const auto& line : lines)
    if (line.get<std::string>().find(text) != std::string::npos)
      return true;
  return false;
}

} // namespace

TEST_F(OverviewResults, ACheckStopsBeforeTheWork)
{
  const auto scan = saveAll("scan.pcd");
  for (const std::string tool : {"pcl_indoor_pipeline", "pcl_room_segmentation"})
    for (const auto& output : {std::string(), " " + path("result.pcd")}) {
      ASSERT_EQ(run(tool, scan + output + " -check"), 0) << said();
      EXPECT_TRUE(says("1 storey, ")) << said();
      EXPECT_FALSE(says("  - ")) << said();
      EXPECT_FALSE(says("Warning")) << said();
      EXPECT_NE(bytesOf(path("out")).find("all is there"), std::string::npos);
      EXPECT_FALSE(fs::exists(path("result.pcd")));
      ASSERT_EQ(run(tool, scan + output + " -check -quiet"), 0);
      EXPECT_EQ(said() + bytesOf(path("out")), "");
    }
  EXPECT_NE(run("pcl_indoor_pipeline", path("missing.pcd") + " -check"), 0);
  EXPECT_NE(run("pcl_indoor_pipeline", scan), 0); // the folder is missing
  EXPECT_TRUE(says("output_dir")) << said();
}

TEST_F(OverviewResults, ACheckTakesSeveralStations)
{
  ASSERT_EQ(
      run("pcl_indoor_pipeline", saveAll("a.pcd") + " " + saveAll("b.pcd") + " -check"),
      0)
      << said();
  EXPECT_TRUE(says("from 2 stations")) << said();
  EXPECT_TRUE(says("50 % where another one is")) << said();
}

TEST_F(OverviewResults, AMissingCeilingIsSaid)
{
  const auto scan = save("scan.pcd", isCeiling);
  ASSERT_EQ(run("pcl_indoor_pipeline", scan + " " + path("result") + " -model none"), 0)
      << said();
  EXPECT_TRUE(says("No ceiling was seen: heights are those of the walls.")) << said();
  const auto overview = jsonOf("result/scene.json")["overview"];
  EXPECT_LT(overview["ceiling_seen"].get<double>(), 0.1);
  EXPECT_GT(overview["floor_seen"].get<double>(), 0.9);
  EXPECT_TRUE(has(overview["consequences"], "No ceiling was seen"));
  EXPECT_NE(bytesOf(path("result/report.html")).find("No ceiling was seen"),
            std::string::npos);
  ASSERT_EQ(run("pcl_room_segmentation",
                scan + " " + path("rooms.pcd") + " -json " + path("rooms.json")),
            0);
  EXPECT_EQ(jsonOf("rooms.json")["overview"], overview);
}

TEST_F(OverviewResults, AnEmptyBuildingUpsideDownIsTurnedAndSaid)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (const auto& p : pcl::indoor::test::bentCorridorWithThreeRooms().points)
    cloud.emplace_back(p.x(), -p.y(), -p.z());
  const auto scan = path("hanging.pcd");
  pcl::io::savePCDFileBinary(scan, cloud);
  const std::string line =
      "The scan is upside down: taken as upright along -z (-up -z). "
      "Taken along z, 3 of 3 passages";
  const auto isTurned = [&](const Json& json) {
    EXPECT_TRUE(says(line)) << said();
    EXPECT_TRUE(has(json["warnings"], line));
    EXPECT_EQ(json["overview"]["up"], Json({0.0, 0.0, -1.0}));
    EXPECT_EQ(json["rooms"].size(), 4u);
  };
  ASSERT_EQ(run("pcl_room_segmentation",
                scan + " " + path("rooms.pcd") + " -json " + path("rooms.json")),
            0);
  isTurned(jsonOf("rooms.json"));
  ASSERT_EQ(run("pcl_indoor_pipeline", scan + " " + path("result") + " -model none"),
            0);
  isTurned(jsonOf("result/scene.json"));
}

TEST_F(OverviewResults, AFewChairsTellWhichEndIsUp)
{
  using pcl::indoor::test::cloudOf;
  const auto points = pcl::indoor::test::roomWithChairs({0.0f, 0.0f, 0.0f});
  const auto upright = path("upright.pcd"), hanging = path("hanging.pcd");
  pcl::io::savePCDFileBinary(upright, *cloudOf(points));
  pcl::io::savePCDFileBinary(hanging, *cloudOf(pcl::indoor::test::upsideDown(points)));
  for (const std::string tool : {"pcl_indoor_pipeline", "pcl_room_segmentation"}) {
    ASSERT_EQ(run(tool, upright + " -check"), 0);
    EXPECT_TRUE(says("Up: z, by floors and walls; objects are recognised")) << said();
    ASSERT_EQ(run(tool, hanging + " -check"), 0);
    EXPECT_TRUE(says("Up: -z, by floors and walls; objects are recognised")) << said();
  }
  ASSERT_EQ(run("pcl_indoor_pipeline", hanging + " -check -network none"), 0);
  EXPECT_TRUE(says("Up: z, by floors and walls; no furniture")) << said();
  ASSERT_EQ(run("pcl_room_segmentation",
                hanging + " " + path("rooms.pcd") + " -json " + path("rooms.json")),
            0);
  const auto rooms = jsonOf("rooms.json");
  EXPECT_TRUE(has(rooms["warnings"],
                  "The scan is upside down: taken as upright along -z (-up -z)."));
  EXPECT_EQ(rooms["overview"]["up"], Json({0.0, 0.0, -1.0}));
  ASSERT_EQ(run("pcl_room_segmentation", hanging + " " + path("r.pcd") + " -up z"), 0);
  EXPECT_TRUE(says("Up: z, as set.")) << said();
}

TEST_F(OverviewResults, AResultWithoutRoomsSaysWhy)
{
  const auto scan = save("slice.pcd", isNoSlice);
  const std::string line = "no room was found: The scan is a slice or a flat map, 0.4";
  ASSERT_EQ(
      run("pcl_indoor_pipeline", scan + " " + path("result") + " -model none -quiet"),
      0);
  EXPECT_TRUE(says("[pcl_indoor_pipeline] " + scan + ": " + line)) << said();
  EXPECT_TRUE(has(jsonOf("result/scene.json")["warnings"], line));
  ASSERT_EQ(run("pcl_room_segmentation",
                scan + " " + path("rooms.pcd") + " -quiet -json " + path("rooms.json")),
            0);
  EXPECT_TRUE(says("[pcl_room_segmentation] " + scan + ": " + line)) << said();
  EXPECT_TRUE(has(jsonOf("rooms.json")["warnings"], line));
}

TEST_F(OverviewResults, DegreesAndFeetAreGuessedWhereNoRoomIsFound)
{
  pcl::PointCloud<pcl::PointXYZ> degrees, feet;
  for (const auto& p : pcl::indoor::test::twoRooms().points) {
    degrees.emplace_back(p.x() / 75000.0f, p.y() / 111000.0f, p.z());
    if (p.z() < 0.03f || p.z() > 2.47f) // no walls
      feet.emplace_back(p.x() / 0.3048f, p.y() / 0.3048f, p.z() / 0.3048f);
  }
  pcl::io::savePCDFileBinary(path("degrees.pcd"), degrees);
  ASSERT_EQ(run("pcl_room_segmentation", path("degrees.pcd") + " " + path("rooms.pcd")),
            0);
  EXPECT_TRUE(says("no room was found: x and y extend over less than a hundredth of "
                   "the height, as longitude and latitude in degrees do"))
      << said();
  pcl::io::savePCDFileBinary(path("feet.pcd"), feet);
  ASSERT_EQ(run("pcl_room_segmentation",
                path("feet.pcd") + " " + path("rooms.pcd") + " -min_area 500"),
            0);
  EXPECT_TRUE(says("no room was found: Its rooms seem to be 8.2 m high, in feet they "
                   "would be 2.5 m: if they are, set -unit ft."))
      << said();
}

TEST_F(OverviewResults, WarningsOfTheFileReachTheSceneAlsoOfAnotherRun)
{
  const auto scan = save(
      "far.pcd", [](const auto&) { return false; }, 4e6); // 0.25 m
  const std::string pipeline = scan + " " + path("result") + " -model none";
  ASSERT_EQ(run("pcl_indoor_pipeline", pipeline), 0) << said();
  ASSERT_TRUE(says("Warning: " + scan + ": The coordinates are stored in steps"))
      << said();
  EXPECT_TRUE(has(jsonOf("result/scene.json")["warnings"], "stored in steps"));
  // a run that ends after the rooms is gone on with
  fs::create_symlink("/dev/full", path("report.html"));
  const auto again =
      scan + " " + path("again") + " -model none -report " + path("report.html");
  ASSERT_NE(run("pcl_indoor_pipeline", again), 0);
  ASSERT_TRUE(fs::exists(path("again/.unfinished/scene"))) << said();
  fs::remove(path("report.html"));
  ASSERT_EQ(run("pcl_indoor_pipeline", again), 0) << said();
  EXPECT_TRUE(says("stored in steps")) << said();
  EXPECT_TRUE(has(jsonOf("again/scene.json")["warnings"], "stored in steps"));
}

TEST_F(OverviewResults, AReportInThePlaceOfAnotherResultIsRefusedAtOnce)
{
  const auto scan = saveAll("scan.pcd");
  for (const std::string name : {"scene.json", "./plan.svg"}) {
    EXPECT_NE(run("pcl_indoor_pipeline",
                  scan + " " + path("result") + " -report " + path("result/") + name),
              0);
    EXPECT_TRUE(says("-report: ")) << said();
    EXPECT_FALSE(fs::exists(path("result")));
  }
}
