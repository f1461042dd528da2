/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/io/input_error.h>
#include <pcl/scene/storey_maps.h>

#include "export/robot_map.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::indoor;
using test::SceneJson;
using test::SmallScene;

namespace {

/** At a place of the file; -2 = beside the map. */
int
valueAt(const StoreyMap& map, const Eigen::Vector3d& place, double metres_per_unit = 1)
{
  const Eigen::Vector3d local =
      map.turn.conjugate() * (place - map.lower_left_corner) * metres_per_unit;
  const int x = static_cast<int>(std::floor(local.x() / map.resolution));
  const int y = static_cast<int>(std::floor(local.y() / map.resolution));
  if (x < 0 || y < 0 || x >= map.nx || y >= map.ny)
    return -2;
  return map.cells[static_cast<std::size_t>(y) * map.nx + x];
}

} // namespace

TEST(StoreyMaps, AreThoseOfTheRobotMapInTheFrameOfTheFile)
{
  const auto scene = SmallScene::json();
  for (const bool with_furniture : {false, true}) {
    const auto maps = storeyMaps(scene.dump(), 0.05, with_furniture);
    ASSERT_EQ(maps.size(), 2u);
    const auto expected =
        tool::robotMap(tool::savedScene(scene), 0, 0.05, with_furniture);
    ASSERT_EQ(maps[0].nx, expected.nx);
    ASSERT_EQ(maps[0].ny, expected.ny);
    for (std::size_t i = 0; i < expected.cells.size(); ++i)
      ASSERT_EQ(maps[0].cells[i],
                expected.cells[i] == tool::FreeCell       ? 0
                : expected.cells[i] == tool::OccupiedCell ? 100
                                                          : -1);
    EXPECT_EQ(valueAt(maps[0], {103, 201, 10}), 0);
    EXPECT_EQ(valueAt(maps[0], {104.1, 202.5, 10}), 100); // a wall
    EXPECT_EQ(valueAt(maps[0], {101, 202, 10}), with_furniture ? 100 : 0);
    EXPECT_DOUBLE_EQ(maps[0].lower_left_corner.z(), 10.0);
    EXPECT_DOUBLE_EQ(maps[1].lower_left_corner.z(), 13.0);
  }
}

TEST(StoreyMaps, FollowTheAxesAndTheUnitOfTheFile)
{
  // y is up, the floor's second direction is -z, and numbers are millimetres
  auto scene = SmallScene::json();
  const auto turned = [](SceneJson::reference place) {
    place = {place[0].get<double>() * 1000,
             place[2].get<double>() * 1000,
             place[1].get<double>() * -1000};
  };
  scene["coordinate_unit"] = "mm";
  scene["axes"] = {{"x", {1, 0, 0}}, {"y", {0, 0, -1}}, {"up", {0, 1, 0}}};
  turned(scene["offset"]);
  for (auto& room : scene["rooms"])
    for (auto& ring : room["footprint"])
      for (auto& corner : ring)
        turned(corner);
  for (auto& wall : scene["walls"])
    for (const char* end : {"begin", "end"})
      turned(wall[end]);
  for (auto& opening : scene["openings"])
    turned(opening["position"]);
  for (auto& object : scene["objects"])
    turned(object["upright_box"]["center"]);
  const auto maps = storeyMaps(scene.dump(), 0.05, false);
  ASSERT_EQ(maps.size(), 2u);
  EXPECT_EQ(valueAt(maps[0], {103000, 10000, -201000}, 1e-3), 0);
  EXPECT_EQ(valueAt(maps[0], {104100, 10000, -202500}, 1e-3), 100);
  EXPECT_EQ(valueAt(maps[0], {99600, 10000, -201000}, 1e-3), -1);
  EXPECT_NEAR(maps[0].lower_left_corner.y(), 10000.0, 1e-6);
}

TEST(StoreyMaps, RefuseWhatIsNoScene)
{
  EXPECT_THROW(storeyMaps("", 0.05, false), InputError);
  EXPECT_THROW(storeyMaps("{}", 0.05, false), InputError);
  EXPECT_THROW(storeyMaps(SmallScene::json().dump(), 0.0, false), InputError);
  EXPECT_THROW(storeyMaps(SmallScene::json().dump(), -0.05, false), InputError);
  EXPECT_THROW(storeyMaps(SmallScene::json().dump(), NAN, false), InputError);
  EXPECT_THROW(storeyMaps(SmallScene::json().dump(), 1e-7, false), InputError);
}
