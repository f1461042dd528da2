/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/robot_map.h"

#include "files/tool_error.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::indoor::tool;
using pcl::indoor::test::SmallScene;

namespace {

std::uint8_t
cellAt(const RobotMap& map, double x, double y)
{
  return map.at(static_cast<int>(std::floor((x - map.origin.x()) / map.resolution)),
                static_cast<int>(std::floor((y - map.origin.y()) / map.resolution)));
}

double
areaOf(const RobotMap& map, MapCell value)
{
  double cells = 0.0;
  for (const auto cell : map.cells)
    cells += cell == value ? 1.0 : 0.0;
  return cells * map.resolution * map.resolution;
}

RobotMap
smallMap(bool with_furniture, std::uint32_t storey = 0)
{
  return robotMap(savedScene(SmallScene::json()), storey, 0.05, with_furniture);
}

} // namespace

TEST(RobotMap, RoomsAndDoorsAreFree)
{
  const auto map = smallMap(false);
  EXPECT_EQ(cellAt(map, 1.0, 1.0), FreeCell);
  EXPECT_EQ(cellAt(map, 4.1, 1.5), FreeCell);       // the door
  EXPECT_EQ(cellAt(map, 4.1, 2.5), OccupiedCell);   // its wall
  EXPECT_EQ(cellAt(map, 5.55, 1.25), OccupiedCell); // the pillar
  EXPECT_EQ(cellAt(map, 8.23, 1.5), FreeCell);      // the door at the end
  EXPECT_EQ(cellAt(map, 8.23, 2.5), OccupiedCell);  // beside it
  EXPECT_EQ(cellAt(map, -0.4, 1.0), UnknownCell);
  // two rooms, the door through the wall, half of the door at the end
  EXPECT_NEAR(areaOf(map, FreeCell), 12.0 + 11.75 + 0.9 * 0.2 + 1.0 * 0.1, 0.15);
}

TEST(RobotMap, FurnitureAndClosedDoorsAreOccupied)
{
  const auto map = smallMap(true);
  EXPECT_EQ(cellAt(map, 1.0, 2.0), OccupiedCell); // the chair
  EXPECT_EQ(cellAt(map, 4.1, 1.5), FreeCell);     // an open door
  EXPECT_EQ(cellAt(map, 8.2, 1.5), OccupiedCell); // a closed one
  auto json = SmallScene::json();
  json["objects"][0]["upright_box"]["center"][2] = 12.6; // hangs under the ceiling
  EXPECT_EQ(cellAt(robotMap(savedScene(json), 0, 0.05, true), 1.0, 2.0), FreeCell);
}

TEST(RobotMap, StoreysAreApart)
{
  EXPECT_NEAR(areaOf(smallMap(false, 1), FreeCell), 12.0, 0.15);
}

TEST(RobotMap, FilesAreAsAMapServerReadsThem)
{
  const auto map = smallMap(false);
  const auto bytes = pgmBytes(map);
  const auto header =
      "P5\n" + std::to_string(map.nx) + " " + std::to_string(map.ny) + "\n255\n";
  ASSERT_EQ(bytes.rfind(header, 0), 0u);
  ASSERT_EQ(bytes.size(), header.size() + map.cells.size());
  // the first row is the highest
  const auto first = static_cast<std::uint8_t>(bytes[header.size() + map.nx / 2]);
  EXPECT_EQ(first, map.at(map.nx / 2, map.ny - 1));
  EXPECT_EQ(mapYaml(map, "it's.pgm"),
            "image: 'it''s.pgm'\nmode: trinary\nresolution: 0.05\norigin: [-0.5, -0.6, "
            "0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

TEST(RobotMap, ItsSizeIsBounded)
{
  auto json = SmallScene::json();
  json["rooms"][0]["footprint"][0][1][0] = 1e6;
  EXPECT_THROW(robotMap(savedScene(json), 0, 0.05, false), ToolError);
  json["rooms"] = pcl::indoor::test::SceneJson::array();
  json["walls"] = json["openings"] = json["objects"] = json["rooms"];
  EXPECT_TRUE(robotMap(savedScene(json), 0, 0.05, false).cells.empty());
}
