/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/scene_plan.h"

#include "pictures/plan_dxf.h"
#include "pictures/plan_svg.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::indoor::tool;
using pcl::indoor::test::SmallScene;

TEST(ScenePlan, HasRoomsDoorsAndObjects)
{
  const auto plan = scenePlan(savedScene(SmallScene::json()));
  EXPECT_EQ(plan.origin, Eigen::Vector2d(100.0, 200.0));
  ASSERT_EQ(plan.storeys.size(), 2u);
  const auto& storey = plan.storeys[0];
  EXPECT_EQ(storey.rooms.size(), 2u);
  ASSERT_EQ(storey.openings.size(), 2u); // the window is none
  EXPECT_EQ(storey.openings[0].number, 1u);
  EXPECT_NEAR(std::abs(storey.openings[0].along.y()), 1.0, 1e-12);
  EXPECT_NEAR(storey.openings[0].into.x(), 1.0, 1e-12); // room 2 is smaller
  EXPECT_EQ(storey.objects.size(), 2u);
  EXPECT_EQ(storey.windows.size(), 1u);
  double length = 0.0;
  for (const auto& [begin, end] : storey.walls)
    length += (end - begin).norm();
  EXPECT_NEAR(length, 14.0 + 14.0 + 2.0 - 2 * 0.9 - 1.0, 1e-6); // without the doors
}

TEST(ScenePlan, CanBeDrawn)
{
  const auto plan = scenePlan(savedScene(SmallScene::json()));
  const auto svg = planSvg(plan);
  EXPECT_NE(svg.find("id=\"storey-1\""), std::string::npos);
  EXPECT_NE(svg.find("id=\"room-2\""), std::string::npos);
  EXPECT_NE(svg.find(">kitchen 11.8 m²<"), std::string::npos);
  EXPECT_NE(svg.find(">12.0 m²<"), std::string::npos); // no name
  EXPECT_EQ(svg.find("unknown"), std::string::npos);
  EXPECT_NE(planDxf(plan).find("104.2000"), std::string::npos); // places of the scan
  EXPECT_NE(planDxf(plan).find("\nkitchen 11.8 m2\n"), std::string::npos);
}
