/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/model_json.h"

#include <gtest/gtest.h>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

/** A wall of 4 m between rooms 1 and 2 with a window in it, and a door in none. */
BuildingModel
wallWithWindow()
{
  BuildingModel model;
  ModelWall wall;
  wall.storey = 1;
  wall.begin = {1.0, 2.0};
  wall.end = {5.0, 2.0};
  wall.floor = 3.0;
  wall.height = 2.5;
  wall.thickness = 0.24;
  wall.rooms = {1, 2};
  model.walls = {wall};
  ModelOpening window;
  window.kind = ModelOpeningKind::Window;
  window.room_a = 2;
  window.storey = 1;
  window.position = {2.0, 2.0, 3.9};
  window.width = 1.2;
  window.height = 1.5;
  window.sill = 0.9;
  ModelOpening door;
  door.room_a = 1;
  door.room_b = 2;
  door.wall = 1; // none
  door.position = {4.0, 2.0, 3.0};
  door.is_open = true;
  model.openings = {window, door};
  return model;
}

} // namespace

TEST(ModelJson, PlacesAreThoseOfTheFileAndLengthsMetres)
{
  const auto model = wallWithWindow();
  Eigen::Affine3d to_file =
      Eigen::Affine3d::Identity(); // y of the building is -x of the
  to_file.linear() << 0.0, -1000.0, 0.0, 1000.0, 0.0, 0.0, 0.0, 0.0,
      1000.0; // file, in mm
  to_file.translation() << 100.0, 200.0, 300.0;
  const auto walls = wallsJson(model, to_file);
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_EQ(walls[0]["begin"].dump(), "[-1900.0,1200.0,3300.0]");
  EXPECT_EQ(walls[0]["end"].dump(), "[-1900.0,5200.0,3300.0]");
  EXPECT_EQ(walls[0]["rooms"].dump(), "[1,2]");
  EXPECT_EQ(walls[0]["thickness"], 0.24);
  EXPECT_EQ(walls[0]["height"], 2.5);
  const auto openings = openingsJson(model, to_file);
  ASSERT_EQ(openings.size(), 2u);
  EXPECT_EQ(openings[0]["kind"], "window");
  EXPECT_EQ(openings[0]["rooms"].dump(), "[2,0]");
  EXPECT_EQ(openings[0]["position"].dump(), "[-1900.0,2200.0,4200.0]");
  EXPECT_EQ(openings[0]["width"], 1.2);
  EXPECT_EQ(openings[0]["sill"], 0.9);
  EXPECT_EQ(openings[0]["head"], 2.4);
  EXPECT_EQ(openings[0]["area"], 1.8);
  EXPECT_EQ(openings[0]["open"], false);
  EXPECT_EQ(openings[0]["wall"], 1);
}

TEST(ModelJson, WhatIsNotKnownIsAbsent)
{
  auto model = wallWithWindow();
  model.walls[0].thickness = 0.0; // one side was seen
  const Eigen::Affine3d here = Eigen::Affine3d::Identity();
  EXPECT_FALSE(wallsJson(model, here)[0].contains("thickness"));
  EXPECT_FALSE(openingsJson(model, here)[1].contains("wall"));
  EXPECT_TRUE(openingsJson(model, here)[1]["open"].get<bool>());
  EXPECT_EQ(wallsJson({}, here).dump(), "[]");
  EXPECT_EQ(openingsJson({}, here).dump(), "[]");
}
