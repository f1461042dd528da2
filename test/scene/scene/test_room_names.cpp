/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/scene/room_names.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::indoor;

namespace {

Room
rectangle(std::uint32_t label, std::uint32_t storey, double length, double width)
{
  Room room;
  room.label = label;
  room.storey = storey;
  room.area = length * width;
  room.height = 2.5;
  room.footprint = {{{0, 0, 0}, {length, 0, 0}, {length, width, 0}, {0, width, 0}}};
  return room;
}

ModelOpening
opening(ModelOpeningKind kind, std::uint32_t a, std::uint32_t b, double width)
{
  ModelOpening made;
  made.kind = kind;
  made.room_a = a;
  made.room_b = b;
  made.width = width;
  made.height = 2.0;
  return made;
}

SceneObject
object(std::uint32_t room, double middle, double height)
{
  SceneObject made;
  made.room = room;
  made.upright.center = {0.0, 0.0, middle};
  made.upright.size = {1.0, 0.5, height};
  return made;
}

/** Rooms 1 and 2 on one storey, 3 above; a bed in room 1, a chair in none, a floor. */
Scene
threeRooms()
{
  Scene scene;
  scene.frame.pose.translation() = Eigen::Vector3d(5.0, 6.0, 100.0);
  scene.building.rooms = {
      rectangle(1, 0, 4.0, 3.0), rectangle(2, 0, 6.0, 1.5), rectangle(3, 1, 2.0, 2.0)};
  scene.building.heights.resize(2);
  scene.building.heights[0].floor = 0.5;
  scene.building.heights[1].floor = 3.5;
  scene.model.openings = {opening(ModelOpeningKind::Door, 1, 2, 0.9),
                          opening(ModelOpeningKind::Window, 1, 0, 1.5),
                          opening(ModelOpeningKind::Door, 3, 0, 2.0),
                          opening(ModelOpeningKind::Door, 2, 0, 1.0),
                          opening(ModelOpeningKind::Door, 2, 0, 3.0)};
  scene.objects = {object(1, 101.0, 0.6), object(0, 101.0, 1.0), object(2, 100.5, 0.1)};
  scene.objects[2].structure = 1;
  scene.classes.names = {"none", "bed", "chair"};
  scene.classes.objects.resize(3);
  scene.classes.objects[0].top = {{1, 0.7f}, {2, 0.2f}};
  scene.classes.objects[1].top = {{2, 0.9f}};
  return scene;
}

} // namespace

TEST(RoomEvidence, HoldsSizesOfRooms)
{
  const auto rooms = roomEvidence(threeRooms());
  ASSERT_EQ(rooms.size(), 3u);
  EXPECT_DOUBLE_EQ(rooms[0].area, 12.0);
  EXPECT_DOUBLE_EQ(rooms[0].perimeter, 14.0);
  EXPECT_DOUBLE_EQ(rooms[1].perimeter, 15.0);
  EXPECT_DOUBLE_EQ(rooms[2].height, 2.5);
  EXPECT_EQ(rooms[2].storey, 1u);
}

TEST(RoomEvidence, WindowsAndWideDoorsToTheOutsideAreGlass)
{
  const auto rooms = roomEvidence(threeRooms());
  EXPECT_DOUBLE_EQ(rooms[0].window_area, 3.0);
  EXPECT_DOUBLE_EQ(rooms[1].window_area, 0.0); // a front door and a gate
  EXPECT_DOUBLE_EQ(rooms[2].window_area, 4.0);
}

TEST(RoomEvidence, DoorsLeadToRooms)
{
  const auto rooms = roomEvidence(threeRooms());
  EXPECT_EQ(rooms[0].neighbours, std::vector<std::size_t>{1});
  EXPECT_EQ(rooms[1].neighbours, std::vector<std::size_t>{0});
  EXPECT_TRUE(rooms[2].neighbours.empty());
}

TEST(RoomEvidence, ObjectsStandOnTheFloorOfTheirStorey)
{
  const auto rooms = roomEvidence(threeRooms());
  ASSERT_EQ(rooms[0].objects.size(), 1u);
  const auto& bed = rooms[0].objects[0];
  ASSERT_EQ(bed.classes.size(), 2u);
  EXPECT_EQ(bed.classes[0].first, "bed");
  EXPECT_NEAR(bed.classes[0].second, 0.7, 1e-6);
  EXPECT_NEAR(bed.foot, 101.0 - 0.3 - 100.0 - 0.5, 1e-9);
  EXPECT_TRUE(rooms[1].objects.empty()); // a floor is no object
}

TEST(RoomEvidence, ConfidencesBecomeProbabilities)
{
  auto scene = threeRooms();
  scene.classes.objects[0].top = {{1, 7.0f}, {2, -1.0f}, {2, NAN}};
  const auto rooms = roomEvidence(scene);
  ASSERT_EQ(rooms[0].objects.size(), 1u);
  ASSERT_EQ(rooms[0].objects[0].classes.size(), 1u);
  EXPECT_EQ(rooms[0].objects[0].classes[0].second, 1.0);
  EXPECT_EQ(roomNames(scene).size(), 3u);
}

TEST(RoomEvidence, ASceneWithoutClassesHasNoObjects)
{
  auto scene = threeRooms();
  scene.classes = {};
  const auto rooms = roomEvidence(scene);
  ASSERT_EQ(rooms.size(), 3u);
  EXPECT_TRUE(rooms[0].objects.empty());
}

TEST(RoomNames, AreThoseOfTheEvidence)
{
  const auto scene = threeRooms();
  const auto names = roomNames(scene), expected = nameRooms(roomEvidence(scene));
  ASSERT_EQ(names.size(), 3u);
  for (std::size_t r = 0; r < names.size(); ++r)
    EXPECT_EQ(names[r].probabilities, expected[r].probabilities);
  EXPECT_EQ(names[0].likeliest(), RoomName::Bedroom);
  EXPECT_TRUE(roomNames({}).empty());
}
