/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/saved_scene.h"

#include "files/tool_error.h"
#include "support/folder_test.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::indoor::tool;
using pcl::indoor::test::SceneJson;
using pcl::indoor::test::SmallScene;

namespace {

std::string
refusalOf(const SceneJson& scene)
{
  try {
    savedScene(scene);
  } catch (const std::exception& problem) {
    return problem.what();
  }
  return "";
}

} // namespace

TEST(SavedScene, HasWhatTheFileSays)
{
  const auto scene = savedScene(SmallScene::json());
  EXPECT_EQ(scene.origin, Eigen::Vector3d(100.0, 200.0, 10.0));
  ASSERT_EQ(scene.storeys.size(), 2u);
  EXPECT_EQ(scene.storeys[1].floor, 3.0);
  ASSERT_EQ(scene.rooms.size(), 3u);
  EXPECT_EQ(scene.rooms[1].rings[1][2], Eigen::Vector2d(6.0, 1.5));
  EXPECT_EQ(scene.rooms[2].floor, 3.0);
  EXPECT_EQ(scene.rooms[0].name, ""); // not in the file
  EXPECT_EQ(scene.rooms[1].name, "kitchen");
  EXPECT_EQ(scene.rooms[1].name_probability, 0.8);
  EXPECT_EQ(scene.rooms[2].name, ""); // unknown
  ASSERT_EQ(scene.walls.size(), 2u);
  EXPECT_EQ(scene.walls[0].thickness, 0.2);
  EXPECT_EQ(scene.walls[1].thickness, 0.0);
  ASSERT_EQ(scene.openings.size(), 3u);
  EXPECT_EQ(scene.openings[0].wall, 0u);
  EXPECT_TRUE(scene.openings[0].is_open);
  EXPECT_EQ(scene.openings[1].kind, pcl::indoor::ModelOpeningKind::Window);
  EXPECT_EQ(scene.openings[2].wall, 2u); // none
  ASSERT_EQ(scene.objects.size(), 4u);
  EXPECT_EQ(scene.objects[1].box.center, Eigen::Vector3d(0.5, 1.5, 1.5));
  EXPECT_NEAR(scene.objects[1].box.yaw, M_PI_2, 1e-12);
  EXPECT_EQ(scene.objects[2].storey, 1u); // in no room: its foot is on that floor
  EXPECT_TRUE(scene.objects[3].is_structure);
  EXPECT_EQ(scene.objects[3].name, "");
}

TEST(SavedScene, ColumnsAreSeenFromAbove)
{
  auto json = SmallScene::json();
  json["columns"] = {SmallScene::column(false), SmallScene::column(true)};
  const auto scene = savedScene(json);
  ASSERT_EQ(scene.columns.size(), 2u);
  EXPECT_EQ(scene.columns[1].number, 2u);
  EXPECT_EQ(scene.columns[0].foot, Eigen::Vector3d(5.75, 1.25, 0.0));
  Eigen::AlignedBox2d box;
  for (const auto& corner : outlineOf(scene.columns[0]))
    box.extend(corner);
  EXPECT_LT((box.min() - Eigen::Vector2d(5.625, 1.0)).norm(), 1e-9); // turned by 90
  EXPECT_LT((box.max() - Eigen::Vector2d(5.875, 1.5)).norm(), 1e-9);
  const auto round = outlineOf(scene.columns[1]);
  EXPECT_EQ(round.size(), 24u);
  for (const auto& corner : round)
    EXPECT_NEAR((corner - Eigen::Vector2d(5.75, 1.25)).norm(), 0.25, 1e-9);
  json["columns"][0]["size"][1] = -0.1;
  EXPECT_THROW(savedScene(json), pcl::indoor::InputError);
}

TEST(SavedScene, VersionOneHasDoorsByTheirWidth)
{
  auto json = SmallScene::versionOne();
  json["openings"][1]["width"] = 2.0;
  const auto scene = savedScene(json);
  EXPECT_TRUE(scene.walls.empty());
  ASSERT_EQ(scene.openings.size(), 2u);
  EXPECT_EQ(scene.openings[0].kind, pcl::indoor::ModelOpeningKind::Door);
  EXPECT_NEAR(scene.openings[0].height, 2.0, 1e-12);
  EXPECT_EQ(scene.openings[1].kind, pcl::indoor::ModelOpeningKind::Passage);
}

TEST(SavedScene, StandsUprightInMetres)
{
  auto json = SmallScene::json(); // y is up, in centimetres
  json["coordinate_unit"] = "cm";
  json["axes"] = {{"x", {1, 0, 0}}, {"y", {0, 0, -1}}, {"up", {0, 1, 0}}};
  json["offset"] = {0, 100, 0};
  json["rooms"][0]["footprint"][0][1] = {400, 150, -300};
  json["storeys"][0]["floor"] = 1.5;
  json["objects"][0]["upright_box"]["yaw_degrees"] = 90.0;
  const auto scene = savedScene(json);
  EXPECT_TRUE(scene.origin.isApprox(Eigen::Vector3d(0.0, 0.0, 1.0)));
  EXPECT_NEAR(scene.storeys[0].floor, 0.5, 1e-9);
  EXPECT_TRUE(scene.rooms[0].rings[0][1].isApprox(Eigen::Vector2d(4.0, 3.0)));
  EXPECT_NEAR(std::sin(scene.objects[0].box.yaw), 1.0, 1e-9);
  EXPECT_TRUE((scene.frame.uprightToFile() * Eigen::Vector3d(4.0, 3.0, 0.5))
                  .isApprox(Eigen::Vector3d(400.0, 150.0, -300.0)));
}

TEST(SavedScene, RefusesNumbersOfNothing)
{
  for (const auto& [path, value, reason] :
       std::initializer_list<std::tuple<const char*, SceneJson, const char*>>{
           {"/rooms/0/storey", 2, "no storey 2"},
           {"/rooms/1/room", 7, "not numbered"},
           {"/rooms/1/name", "<b>", "'<b>' is no name"},
           {"/rooms/1/name_probability", -1, "out of range"},
           {"/walls/0/storey", -1, "no storey -1"},
           {"/openings/0/rooms/1", 4, "no room 4"},
           {"/openings/0/wall", 3, "no wall 3"},
           {"/openings/0/wall", 0, "no wall 0"},
           {"/openings/0/kind", "gate", "'gate'"},
           {"/openings/0/width", -1, "out of range"},
           {"/objects/0/upright_box/size/1", -1, "object 1"},
           {"/axes/up", {0, 0, 0}, "axes"},
           {"/axes/y", {1, 0, 0}, "axes"},
           {"/rooms/0/footprint/0/0/0", 1e300, "out of range"},
           {"/rooms/0/footprint/0/0", {1, 2}, ""},
           {"/rooms/0/area", "big", ""}}) {
    auto json = SmallScene::json();
    json[SceneJson::json_pointer(path)] = value;
    const auto said = refusalOf(json);
    EXPECT_NE(said, "") << path;
    EXPECT_NE(said.find(reason), std::string::npos) << said;
  }
}

using SavedSceneFile = pcl::indoor::test::FolderTest;

TEST_F(SavedSceneFile, RefusalsNameTheFile)
{
  auto json = SmallScene::json();
  json.erase("walls");
  const auto path = write("scene.json", json.dump());
  try {
    readSavedScene(path);
    FAIL();
  } catch (const ToolError& problem) {
    EXPECT_EQ(std::string(problem.what()).rfind(path + ": not a whole scene", 0), 0u)
        << problem.what();
  }
}
