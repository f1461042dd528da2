/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl_indoor_ros/scene_markers.h>

#include "ros2/messages.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

using namespace pcl::indoor::test;

namespace {

MarkerArray
markersOf(const SceneJson& scene)
{
  Header header;
  header.frame_id = "map";
  return pcl_indoor_ros::SceneMarkers<MarkerArray>(
             scene, Eigen::Vector3d(100, 200, 10), header)
      .make();
}

/** Without coordinates if there is none. */
Marker
markerOf(const MarkerArray& array, const std::string& name_space, int id)
{
  for (const auto& marker : array.markers)
    if (marker.ns == name_space && marker.id == id)
      return marker;
  ADD_FAILURE() << "no marker " << id << " of " << name_space;
  Marker none;
  none.points.resize(100);
  return none;
}

} // namespace

TEST(SceneMarkers, DeleteThoseOfBeforeAndAreDistinct)
{
  const auto array = markersOf(SmallScene::json());
  ASSERT_FALSE(array.markers.empty());
  EXPECT_EQ(array.markers[0].action, Marker::DELETEALL);
  std::set<std::tuple<std::string, int>> names;
  for (std::size_t i = 1; i < array.markers.size(); ++i) {
    const auto& marker = array.markers[i];
    EXPECT_TRUE(names.insert({marker.ns, marker.id}).second);
    EXPECT_EQ(marker.header.frame_id, "map");
    EXPECT_EQ(marker.action, Marker::ADD);
    EXPECT_GT(marker.color.a, 0.0f);
  }
  // three rooms, three openings and three objects; a floor is none
  EXPECT_EQ(names.size(), 2u * 3u + 3u + 2u * 3u);
}

TEST(SceneMarkers, OutlineRoomsWithTheirNames)
{
  const auto array = markersOf(SmallScene::json());
  const auto room = markerOf(array, "rooms", 2);
  EXPECT_EQ(room.type, Marker::LINE_LIST);
  ASSERT_EQ(room.points.size(), 2u * (4u + 4u)); // the hole, too
  EXPECT_NEAR(room.points[0].x, 4.2, 1e-9);
  EXPECT_NEAR(room.points[1].x, 8.2, 1e-9);
  EXPECT_NEAR(room.points[7].x, 4.2, 1e-9); // closed
  EXPECT_EQ(markerOf(array, "room_names", 1).text, "1");
  EXPECT_EQ(markerOf(array, "room_names", 2).text, "2 kitchen");
  EXPECT_EQ(markerOf(array, "room_names", 3).text, "3");
  EXPECT_NEAR(markerOf(array, "room_names", 3).pose.position.x, 2.0, 1e-9);
}

TEST(SceneMarkers, FrameOpeningsInTheirWalls)
{
  const auto array = markersOf(SmallScene::json());
  const auto door = markerOf(array, "doors", 1);
  ASSERT_EQ(door.points.size(), 8u);
  for (const auto& point : door.points)
    EXPECT_NEAR(point.x, 4.1, 1e-9); // its wall stands across x
  EXPECT_NEAR(std::abs(door.points[1].y - door.points[0].y), 0.9, 1e-9);
  EXPECT_NEAR(door.points[3].z, 2.0, 1e-9);
  for (const auto& point : markerOf(array, "windows", 2).points)
    EXPECT_NEAR(point.y, 0.0, 1e-9);
  for (const auto& point : markerOf(array, "doors", 3).points) // without a wall
    EXPECT_NEAR(point.x, 8.2, 1e-9);
}

TEST(SceneMarkers, BoxObjectsWithTheirNames)
{
  const auto array = markersOf(SmallScene::json());
  const auto chair = markerOf(array, "objects", 1);
  EXPECT_EQ(chair.type, Marker::CUBE);
  EXPECT_NEAR(chair.pose.position.x, 1.0, 1e-9);
  EXPECT_NEAR(chair.scale.y, 0.5, 1e-9);
  EXPECT_NEAR(chair.pose.orientation.w, 1.0, 1e-9);
  const auto stairs = markerOf(array, "objects", 2); // turned by 90 degrees
  EXPECT_NEAR(stairs.pose.orientation.z, std::sqrt(0.5), 1e-9);
  EXPECT_EQ(markerOf(array, "object_names", 2).text, "2 stairs");
  EXPECT_NEAR(markerOf(array, "object_names", 2).pose.position.z, 3.15, 1e-9);
}

TEST(SceneMarkers, StandAlongTheUpAxisOfTheFile)
{
  auto scene = SmallScene::json();
  scene["axes"] = {{"x", {1, 0, 0}}, {"y", {0, 0, -1}}, {"up", {0, 1, 0}}};
  const auto chair = markerOf(markersOf(scene), "objects", 1);
  const Eigen::Quaterniond turn(chair.pose.orientation.w,
                                chair.pose.orientation.x,
                                chair.pose.orientation.y,
                                chair.pose.orientation.z);
  EXPECT_LT((turn * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitY()).norm(), 1e-9);
}

TEST(SceneMarkers, NeedAWholeScene)
{
  EXPECT_THROW(markersOf(SceneJson::object()), nlohmann::json::exception);
}
