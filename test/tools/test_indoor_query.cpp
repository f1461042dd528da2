/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Asks pcl_indoor_query about a small scene.
#include "support/folder_test.h"
#include "support/run_tool.h"
#include "support/small_scene.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using pcl::indoor::test::bytesOf;
using Json = nlohmann::json;

/** Two storeys with a room each. */
Json
smallScene()
{
  const auto object =
      [](int number, const char* name, int room, double x, double side) {
        return Json{{"object", number},
                    {"room", room},
                    {"storey", room - 1},
                    {"structure", "none"},
                    {"category", 1},
                    {"class", name},
                    {"confidence", 0.75},
                    {"upright_box",
                     {{"center", {x, 0.0, 1.0}},
                      {"size", {side, 0.5, 0.5}},
                      {"yaw_degrees", 90.0}}}};
      };
  Json scene = {{"format", "pcl_indoor scene"},
                {"version", 2},
                {"coordinate_unit", "m"},
                {"axes", {{"x", {1, 0, 0}}, {"y", {0, 1, 0}}, {"up", {0, 0, 1}}}},
                {"categories", {"none", "door", "chair"}},
                {"storeys", {{{"storey", 0}}, {{"storey", 1}}}},
                {"rooms", {{{"room", 1}}, {{"room", 2}}}},
                {"objects",
                 {object(1, "door", 1, 0.0, 2.0),
                  object(2, "chair", 1, 2.0, 1.0),
                  object(3, "door", 2, 4.0, 2.2),
                  object(4, "door", 2, 20.0, 2.0)}}};
  scene["objects"][3]["structure"] = "wall";
  return scene;
}

class IndoorQuery : public pcl::indoor::test::FolderTest {
protected:
  void
  SetUp() override
  {
    FolderTest::SetUp();
    save(smallScene());
  }

  void
  save(const Json& scene) const
  {
    std::ofstream(path("scene.json")) << scene;
  }

  int
  run(const std::string& options) const
  {
    return pcl::indoor::test::runTool("pcl_indoor_query",
                                      path("scene.json") + " " + options,
                                      path("out"),
                                      path("said"));
  }

  std::vector<int>
  objectsOf(const std::string& options) const
  {
    EXPECT_EQ(run(options + " -json"), 0) << bytesOf(path("said"));
    std::vector<int> numbers;
    for (const auto& object : Json::parse(bytesOf(path("out"))))
      numbers.push_back(object["object"]);
    return numbers;
  }

  void
  expectRefused(const std::string& options, const std::string& reason) const
  {
    EXPECT_NE(run(options), 0) << options;
    const auto said = bytesOf(path("said"));
    EXPECT_NE(said.find(reason), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_EQ(bytesOf(path("out")), "");
  }
};

using Numbers = std::vector<int>;

} // namespace

TEST_F(IndoorQuery, AllConditionsHold)
{
  EXPECT_EQ(objectsOf(""), (Numbers{1, 2, 3}));
  EXPECT_EQ(objectsOf("-structure"), (Numbers{1, 2, 3, 4}));
  EXPECT_EQ(objectsOf("-class door"), (Numbers{1, 3}));
  EXPECT_EQ(objectsOf("-class door -room 2"), (Numbers{3}));
  EXPECT_EQ(objectsOf("-storey 0"), (Numbers{1, 2}));
  EXPECT_EQ(objectsOf("-min_size 2"), (Numbers{1, 3}));
  EXPECT_EQ(objectsOf("-max_size 2"), (Numbers{1, 2}));
  EXPECT_EQ(objectsOf("-room 0"), Numbers{});
}

TEST_F(IndoorQuery, TheNextDoorIsFirst)
{
  EXPECT_EQ(objectsOf("-class door -nearest 3,0,1"), (Numbers{3, 1}));
  const auto objects = Json::parse(bytesOf(path("out")));
  EXPECT_EQ(objects[0]["distance"], 0.75); // its length lies along y
  EXPECT_EQ(objects[1]["distance"], 2.75);
  EXPECT_EQ(objectsOf("-nearest -1,0,1 -count 1"), (Numbers{1}));
}

TEST_F(IndoorQuery, DistancesAreMetresAlongTheUpAxis)
{
  auto scene = smallScene();
  scene["coordinate_unit"] = "cm";
  scene["axes"] = {{"x", {0, 0, 1}}, {"y", {1, 0, 0}}, {"up", {0, 1, 0}}};
  save(scene);
  EXPECT_EQ(objectsOf("-nearest 0,101,1 -count 1"), (Numbers{1}));
  EXPECT_EQ(Json::parse(bytesOf(path("out")))[0]["distance"], 1.01 - 0.25);
}

TEST_F(IndoorQuery, TheTableIsAligned)
{
  ASSERT_EQ(run("-class door -nearest 3,0,1"), 0);
  EXPECT_EQ(bytesOf(path("out")),
            "object  class  sure  room  storey             size, m            centre  "
            "distance, m\n"
            "     3  door   75 %     2       1  2.20 x 0.50 x 0.50  4.00, 0.00, 1.00  "
            "       0.75\n"
            "     1  door   75 %     1       0  2.00 x 0.50 x 0.50  0.00, 0.00, 1.00  "
            "       2.75\n");
}

TEST_F(IndoorQuery, RoomsAreFoundByWhatTheyAreFor)
{
  auto scene = smallScene();
  scene["rooms"] = {{{"room", 1},
                     {"storey", 0},
                     {"name", "kitchen"},
                     {"name_probability", 0.81},
                     {"area", 12.3},
                     {"height", 2.5}},
                    {{"room", 2},
                     {"storey", 1},
                     {"name", "unknown"},
                     {"name_probability", 0.4},
                     {"area", 9.0},
                     {"height", 2.4}}};
  save(scene);
  EXPECT_EQ(objectsOf("-room_name kitchen"), (Numbers{1, 2}));
  EXPECT_EQ(objectsOf("-room_name kitchen -class door"), (Numbers{1}));
  EXPECT_EQ(objectsOf("-room_name unknown"), (Numbers{3}));
  EXPECT_EQ(objectsOf("-room_name bath"), Numbers{});
  ASSERT_EQ(run("-rooms"), 0);
  EXPECT_EQ(bytesOf(path("out")),
            "room  name     sure  storey  area, m^2  height, m\n"
            "   1  kitchen  81 %       0      12.30       2.50\n"
            "   2  unknown  40 %       1       9.00       2.40\n");
  ASSERT_EQ(run("-rooms -room_name kitchen -json"), 0);
  EXPECT_EQ(Json::parse(bytesOf(path("out"))), Json::array({scene["rooms"][0]}));
  ASSERT_EQ(run("-rooms -storey 1 -json"), 0);
  EXPECT_EQ(Json::parse(bytesOf(path("out"))), Json::array({scene["rooms"][1]}));
}

TEST_F(IndoorQuery, WaysLeadThroughDoors)
{
  save(pcl::indoor::test::SmallScene::json());
  ASSERT_EQ(run("-route 103,201.5,10:2"), 0) << bytesOf(path("said"));
  const auto table = bytesOf(path("out"));
  EXPECT_NE(table.find("opening"), std::string::npos) << table;
  EXPECT_NE(table.find("103.00, 201.50, 10.00"), std::string::npos) << table;
  EXPECT_EQ(table.find("corner"), std::string::npos) << table;
  ASSERT_EQ(run("-route 1:2 -json"), 0);
  EXPECT_GT(Json::parse(bytesOf(path("out")))["length"], 2.0);
  expectRefused("-route 1:9", "no room '9'");
  expectRefused("-route 1", "FROM:TO");
  expectRefused("-route 1:900,0,0", "in no room");
}

TEST_F(IndoorQuery, WhatIsNotThereIsSaid)
{
  expectRefused("-class sofa", "'sofa' is not one of door, chair");
  expectRefused("-room 3", "there is no room 3");
  expectRefused("-storey 2", "there is no storey 2");
  expectRefused("-room_name garage", "'garage' is not one of kitchen, living");
  for (const char* place : {"1,2", "1,2,x", "1,2,3,4", "nan,0,0", "1;2;3"})
    expectRefused(std::string("-nearest '") + place + "'", "is not X,Y,Z");
  expectRefused("-min_size 2 -max_size 1", "-max_size");
}

TEST_F(IndoorQuery, BadScenesAreRefused)
{
  auto scene = smallScene();
  scene["version"] = 3;
  save(scene);
  expectRefused("", "version 3");
  scene = smallScene();
  scene["objects"][1]["upright_box"]["size"] = {1, "wide", 2};
  save(scene);
  expectRefused("", "scene.json: not a whole scene");
  scene = smallScene();
  scene.erase("axes");
  save(scene);
  expectRefused("", "axes");
  save(Json::array());
  expectRefused("", "not a scene");
  scene = smallScene();
  scene["format"] = 1;
  save(scene);
  expectRefused("", "scene.json: ");
}
