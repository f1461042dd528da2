/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/door_graph.h"

#include "files/tool_error.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace pcl::indoor::tool;
using pcl::indoor::test::SmallScene;

namespace {

using Kinds = std::vector<DoorNodeKind>;

DoorRoute
routeBetween(const SavedScene& scene, const std::vector<Eigen::Vector3d>& places)
{
  const auto graph = doorGraph(scene, places);
  const auto route = shortestRoute(graph,
                                   nodeOf(graph, DoorNodeKind::Place, 1),
                                   nodeOf(graph, DoorNodeKind::Place, 2));
  EXPECT_TRUE(route.has_value());
  return route.value_or(DoorRoute());
}

} // namespace

TEST(DoorGraph, TheWayLeadsThroughTheDoor)
{
  const auto scene = savedScene(SmallScene::json());
  const std::vector<Eigen::Vector3d> places = {{3.0, 1.5, 0.0}, {5.0, 1.5, 0.0}};
  const auto graph = doorGraph(scene, places);
  const auto route = routeBetween(scene, places);
  EXPECT_NEAR(route.length, 2.0, 1e-9); // straight through it
  EXPECT_TRUE(
      std::any_of(route.nodes.begin(), route.nodes.end(), [&](std::size_t node) {
        return graph.nodes[node].kind == DoorNodeKind::Opening &&
               graph.nodes[node].number == 1;
      }));
  EXPECT_GT(routeBetween(scene, {{3.0, 0.2, 0.0}, {5.0, 0.2, 0.0}}).length, 2.9);
}

TEST(DoorGraph, WaysTurnAroundPillars)
{
  const auto scene = savedScene(SmallScene::json());
  const auto route = routeBetween(scene, {{5.2, 1.25, 0.0}, {6.3, 1.25, 0.0}});
  EXPECT_GT(route.length, 1.1 + 0.2); // the pillar is 50 cm wide
  EXPECT_LT(route.length, 2.2);
  EXPECT_NEAR(
      routeBetween(scene, {{4.5, 2.5, 0.0}, {7.5, 2.5, 0.0}}).length, 3.0, 1e-9);
}

TEST(DoorGraph, StairsJoinStoreys)
{
  const auto scene = savedScene(SmallScene::json());
  const auto graph = doorGraph(scene);
  const auto route = shortestRoute(graph,
                                   nodeOf(graph, DoorNodeKind::Room, 2),
                                   nodeOf(graph, DoorNodeKind::Room, 3));
  ASSERT_TRUE(route.has_value());
  EXPECT_EQ(std::count_if(route->nodes.begin(),
                          route->nodes.end(),
                          [&](std::size_t node) {
                            return graph.nodes[node].kind == DoorNodeKind::Stair;
                          }),
            2);
  auto without = SmallScene::json();
  without["objects"][1]["upright_box"]["size"][2] = 9.0; // through both storeys
  const auto apart = doorGraph(savedScene(without));
  EXPECT_FALSE(shortestRoute(apart,
                             nodeOf(apart, DoorNodeKind::Room, 2),
                             nodeOf(apart, DoorNodeKind::Room, 3))
                   .has_value());
}

TEST(DoorGraph, WindowsAreNoWay)
{
  auto json = SmallScene::json();
  json["openings"][0]["kind"] = "window";
  const auto graph = doorGraph(savedScene(json));
  EXPECT_FALSE(shortestRoute(graph,
                             nodeOf(graph, DoorNodeKind::Room, 1),
                             nodeOf(graph, DoorNodeKind::Room, 2))
                   .has_value());
}

TEST(DoorGraph, PlacesAreInRooms)
{
  const auto scene = savedScene(SmallScene::json());
  EXPECT_THROW(doorGraph(scene, {{20.0, 1.0, 0.0}}), ToolError);
  const auto graph = doorGraph(scene, {{-0.5, 1.0, 0.0}, {1.0, 1.0, 4.2}});
  EXPECT_EQ(graph.nodes[nodeOf(graph, DoorNodeKind::Place, 1)].room, 1u);
  EXPECT_EQ(graph.nodes[nodeOf(graph, DoorNodeKind::Place, 2)].room, 3u);
  EXPECT_THROW(nodeOf(graph, DoorNodeKind::Room, 4), ToolError);
}
