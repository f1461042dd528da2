/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Writes a small scene with pcl_indoor_export.
#include "support/folder_test.h"
#include "support/run_tool.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace {

using pcl::indoor::test::bytesOf;
using pcl::indoor::test::runTool;
using pcl::indoor::test::SceneJson;
using pcl::indoor::test::SmallScene;

class IndoorExport : public pcl::indoor::test::FolderTest {
protected:
  int
  run(const SceneJson& scene,
      const std::string& output,
      const std::string& options = "")
  {
    write("scene.json", scene.dump());
    return runTool("pcl_indoor_export",
                   path("scene.json") + " " + path("out/" + output) + " " + options,
                   path("out_text"),
                   path("said"));
  }

  void
  SetUp() override
  {
    FolderTest::SetUp();
    std::filesystem::create_directory(path("out"));
  }

  std::set<std::string>
  results() const
  {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path("out")))
      names.insert(entry.path().filename().string());
    return names;
  }
};

} // namespace

TEST_F(IndoorExport, WritesEachFormatTwiceTheSame)
{
  for (const char* name : {"a.ifc", "a.glb", "a.geojson", "a.dxf", "a.svg"}) {
    ASSERT_EQ(run(SmallScene::json(), name), 0) << bytesOf(path("said"));
    const auto bytes = bytesOf(path(std::string("out/") + name));
    EXPECT_GT(bytes.size(), 100u);
    ASSERT_EQ(run(SmallScene::json(), name), 0);
    EXPECT_EQ(bytesOf(path(std::string("out/") + name)), bytes) << name;
    EXPECT_EQ(bytesOf(path("said")), "");
    EXPECT_EQ(bytesOf(path("out_text")), "");
  }
}

TEST_F(IndoorExport, MapsAreOfAllStoreys)
{
  ASSERT_EQ(run(SmallScene::json(), "map.pgm", "-resolution 0.1"), 0)
      << bytesOf(path("said"));
  EXPECT_EQ(results(),
            (std::set<std::string>{"map.pgm",
                                   "map.yaml",
                                   "map_furnished.pgm",
                                   "map_furnished.yaml",
                                   "map_route.geojson",
                                   "map_storey1.pgm",
                                   "map_storey1.yaml",
                                   "map_storey1_furnished.pgm",
                                   "map_storey1_furnished.yaml",
                                   "map_storey1_route.geojson"}));
  const auto yaml = bytesOf(path("out/map_furnished.yaml"));
  EXPECT_NE(yaml.find("image: 'map_furnished.pgm'\n"), std::string::npos) << yaml;
  EXPECT_NE(yaml.find("resolution: 0.1\n"), std::string::npos) << yaml;
}

TEST_F(IndoorExport, ThePipelineWritesTheSameBesideTheScene)
{
  const auto run_quietly = [&](const std::string& tool, const std::string& arguments) {
    return runTool(tool, arguments + " -quiet", path("out_text"), path("said"));
  };
  const auto files = path("a.pcd") + " " + path("result") + " -model none -report none";
  ASSERT_EQ(run_quietly("pcl_scan_simulation",
                        "random:home:3 " + path("a.pcd") +
                            " -rays_per_pose 15000 -leaf 0.05"),
            0);
  ASSERT_EQ(
      run_quietly("pcl_indoor_pipeline", files + " -ifc -map -geojson -epsg 25832"), 0)
      << bytesOf(path("said"));
  const auto scene = bytesOf(path("result/scene.json"));
  for (const auto* name : {"building.ifc", "building.geojson", "map.pgm"}) {
    ASSERT_EQ(run_quietly("pcl_indoor_export",
                          path("result/scene.json") + " " +
                              path(std::string("out/") + name) + " -epsg 25832"),
              0);
  }
  for (const auto& name : results())
    EXPECT_EQ(bytesOf(path("result/" + name)), bytesOf(path("out/" + name))) << name;
  EXPECT_GE(results().size(), 7u);
  ASSERT_EQ(run_quietly("pcl_indoor_pipeline", files), 0);
  EXPECT_EQ(bytesOf(path("result/scene.json")), scene);
  for (const auto& name : results()) // of an earlier run
    EXPECT_FALSE(std::filesystem::exists(path("result/" + name))) << name;
}

TEST_F(IndoorExport, TheCoordinateSystemIsNamed)
{
  ASSERT_EQ(run(SmallScene::json(), "a.ifc", "-epsg 25832"), 0);
  EXPECT_NE(bytesOf(path("out/a.ifc")).find("'EPSG:25832'"), std::string::npos);
}

TEST_F(IndoorExport, WhatAnOldSceneLacksIsSaidInALine)
{
  ASSERT_EQ(run(SmallScene::versionOne(), "a.ifc"), 0) << bytesOf(path("said"));
  const auto said = bytesOf(path("said"));
  EXPECT_NE(said.find("version 1 has no walls"), std::string::npos) << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1);
  EXPECT_NE(bytesOf(path("out/a.ifc")).find("IFCDOOR("), std::string::npos);
}

TEST_F(IndoorExport, ABadSceneLeavesNothing)
{
  auto scene = SmallScene::json();
  scene["rooms"][0]["storey"] = 9;
  EXPECT_NE(run(scene, "a.ifc"), 0);
  const auto said = bytesOf(path("said"));
  EXPECT_NE(said.find("scene.json: there is no storey 9"), std::string::npos) << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1);
  EXPECT_TRUE(results().empty());
}
