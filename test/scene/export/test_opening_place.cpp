/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/opening_place.h"

#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::indoor::tool;
using pcl::indoor::test::SmallScene;

TEST(OpeningPlace, ReachesTheRoomsOnBothSides)
{
  const auto scene = savedScene(SmallScene::json());
  const auto door = openingPlace(scene, scene.openings[0]);
  EXPECT_EQ(door.along, Eigen::Vector2d(0.0, -1.0)); // as its wall goes
  EXPECT_NEAR(door.left, 0.1, 0.011);
  EXPECT_NEAR(door.right, 0.1, 0.011);
  EXPECT_TRUE(door.middle.isApprox(Eigen::Vector2d(4.1, 1.5)));
}

TEST(OpeningPlace, WithoutAWallSidesTellTheDirection)
{
  const auto scene = savedScene(SmallScene::json());
  const auto door = openingPlace(scene, scene.openings[2]);
  EXPECT_NEAR(std::abs(door.along.y()), 1.0, 1e-12);
  EXPECT_LT(door.left, 0.02); // it lies on the outline
  const auto one = savedScene(SmallScene::versionOne());
  EXPECT_NEAR(std::abs(openingPlace(one, one.openings[0]).along.y()), 1.0, 1e-12);
}

TEST(OpeningPlace, WithoutRoomsItHasADirectionAllTheSame)
{
  auto scene = savedScene(SmallScene::json());
  scene.walls.clear();
  scene.openings[0].wall = 0;
  scene.openings[0].room_a = scene.openings[0].room_b = 0;
  const auto door = openingPlace(scene, scene.openings[0]);
  EXPECT_EQ(door.along, Eigen::Vector2d::UnitX());
  EXPECT_EQ(door.left, 0.0);
}
