/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/scene_route.h"

#include "files/tool_error.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

using namespace pcl::indoor::tool;
using pcl::indoor::test::SceneJson;
using pcl::indoor::test::SmallScene;

TEST(SceneRoute, PlacesAreThoseOfTheFile)
{
  const auto scene = savedScene(SmallScene::json());
  const auto route = sceneRoute(scene, "103,201.5,10:105,201.5,10");
  EXPECT_EQ(route["length"], 2.0);
  const auto& steps = route["steps"];
  EXPECT_EQ(steps.front()["position"], SceneJson({103.0, 201.5, 10.0}));
  EXPECT_EQ(steps.back()["position"], SceneJson({105.0, 201.5, 10.0}));
  EXPECT_EQ(steps.back()["distance"], 2.0);
  EXPECT_EQ(steps.back()["room"], 2);
}

TEST(SceneRoute, RoomsHaveNumbers)
{
  const auto route = sceneRoute(savedScene(SmallScene::json()), "2:3");
  EXPECT_EQ(route["steps"].front()["kind"], "room");
  EXPECT_EQ(route["steps"].back()["number"], 3);
  std::string kinds;
  for (const auto& step : route["steps"])
    if (step["kind"] != "corner")
      kinds += step["kind"].get<std::string>() + " ";
  EXPECT_EQ(kinds, "room opening stairs stairs room ");
}

TEST(SceneRoute, WhatIsNoPlaceIsSaid)
{
  const auto scene = savedScene(SmallScene::json());
  for (const char* ends :
       {"1", "", ":", "1:", "1:4", "0:1", "1:x", "1:1,2", "1:900,1,1", "-1:2", "1:2:3"})
    EXPECT_THROW(sceneRoute(scene, ends), ToolError) << ends;
  auto closed = SmallScene::json();
  closed["openings"] = SceneJson::array();
  EXPECT_THROW(sceneRoute(savedScene(closed), "1:2"), ToolError);
}
