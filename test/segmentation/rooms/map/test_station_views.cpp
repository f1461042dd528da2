/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/exceptions.h>
#include <pcl/segmentation/building_rooms.h>
#include <pcl/segmentation/scan_warnings.h>

#include "support/synthetic_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

using namespace pcl::indoor;

namespace {

const Eigen::Vector3d in_a(3.4, 1.6, 1.5), in_b(5.6, 1.5, 1.5), in_c(8.7, 1.5, 1.5);

const std::vector<test::RoomBox> boxes = {{{0, 0, 0}, {4, 3, 2.5f}, 1},
                                          {{4.1f, 0, 0}, {7.1f, 3, 2.5f}, 2},
                                          {{7.2f, 0, 0}, {10.2f, 3, 2.5f}, 3}};

/** Rooms a, b and c in a row; a door leads from a to b, nothing to c. */
test::LabelledPoints
threeRooms(std::vector<test::Opening> more = {})
{
  more.push_back(test::doorOfTwoRooms());
  return test::rooms(boxes, more);
}

test::Opening
fromBToC(float sill)
{
  return {Eigen::Vector3f(7.05f, 1.0f, sill), Eigen::Vector3f(7.25f, 2.0f, 2.0f)};
}

BuildingRooms
roomsOf(const test::LabelledPoints& scene, const ScanStations& stations)
{
  return segmentBuilding(scene.points, {}, {}, stations);
}

/** Of each point the station with the number of its room. */
ScanStations
measuredFromTheirRooms(const test::LabelledPoints& scene)
{
  return {{in_a, in_b, in_c}, scene.objects};
}

} // namespace

TEST(StationViews, WithoutStationsEverySpaceIsARoom)
{
  const auto building = roomsOf(threeRooms(), {});
  EXPECT_EQ(building.rooms.size(), 3u);
  EXPECT_EQ(building.never_entered, 0u);
  EXPECT_TRUE(building.stations.empty());
}

TEST(StationViews, WhatNoStationLookedIntoIsNoRoom)
{
  const auto scene = threeRooms();
  const auto building = roomsOf(scene, {{in_a}, {}});
  ASSERT_EQ(building.rooms.size(), 2u); // b is seen through the door
  EXPECT_EQ(building.never_entered, 1u);
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    if (scene.points[i].x() > 7.5f) {
      EXPECT_EQ(building.point_labels[i], 0u);
    }
  ASSERT_EQ(building.stations.size(), 1u);
  EXPECT_EQ(building.stations[0].storey, 0);
  ASSERT_GT(building.stations[0].room, 0u);
  EXPECT_LT(building.rooms[building.stations[0].room - 1].centroid.x(), 4.0);
}

TEST(StationViews, ARoomIsWhereAStationStands)
{
  EXPECT_EQ(roomsOf(threeRooms(), {{in_a, in_c}, {}}).rooms.size(), 3u);
}

TEST(StationViews, OneLooksInThroughADoorAndNotThroughAWindow)
{
  const ScanStations stations{{in_a, in_b}, {}};
  EXPECT_EQ(roomsOf(threeRooms({fromBToC(0.05f)}), stations).rooms.size(), 3u);
  EXPECT_EQ(roomsOf(threeRooms({fromBToC(0.9f)}), stations).rooms.size(), 2u);
}

TEST(StationViews, APointIsSeenFromItsOwnStation)
{
  const auto scene = threeRooms();
  ScanStations stations{{in_a, in_c}, std::vector<std::uint32_t>(scene.points.size())};
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    stations.of_point[i] = scene.objects[i] == 1 ? 1 : 2; // b from c, through the wall
  EXPECT_EQ(roomsOf(scene, stations).rooms.size(), 2u);
  std::fill(stations.of_point.begin(), stations.of_point.end(), 0); // not known
  EXPECT_EQ(roomsOf(scene, stations).rooms.size(), 3u);
}

TEST(StationViews, AnAtticThatWasNeverEnteredIsNoRoom)
{
  auto with_attic = boxes;
  with_attic.push_back({{0, 0, 2.7f}, {4, 3, 5.0f}, 4});
  const auto scene = test::rooms(with_attic, {test::doorOfTwoRooms()});
  ScanStations stations{{in_a, in_b, in_c}, {}};
  EXPECT_EQ(roomsOf(scene, {}).rooms.size(), 4u);
  EXPECT_EQ(roomsOf(scene, stations).rooms.size(), 3u);
  stations.positions.emplace_back(1.0, 1.5, 4.0);
  EXPECT_EQ(roomsOf(scene, stations).rooms.size(), 4u);
}

TEST(StationViews, StationsBeyondTheBuildingTellNothing)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Eigen::Vector3d& far : {Eigen::Vector3d(500.0, 1.5, 1.5),
                                     Eigen::Vector3d(1.0, 1.5, 1.5e300),
                                     Eigen::Vector3d(nan, nan, nan)}) {
    const auto building = roomsOf(threeRooms(), {{far}, {}});
    EXPECT_EQ(building.rooms.size(), 3u);
    const auto warnings = unseenWarnings(building);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("No station stands in a room"), std::string::npos);
  }
}

TEST(StationViews, WhatIsNoRoomIsSaid)
{
  const auto warnings = unseenWarnings(roomsOf(threeRooms(), {{in_a}, {}}));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("1 space is no room: no station"), std::string::npos);
}

TEST(StationViews, WhatOthersMeasuredPartsNoRoom)
{
  const auto scene = threeRooms(); // c is a room of its own
  auto stations = measuredFromTheirRooms(scene);
  EXPECT_EQ(roomsOf(scene, stations).rooms.size(), 3u);
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    if (scene.points[i].x() > 3.9f && scene.points[i].x() < 4.2f)
      stations.of_point[i] = 3; // a mirror image
  const auto building = roomsOf(scene, stations);
  ASSERT_EQ(building.rooms.size(), 2u);
  const auto largest = std::max(building.rooms[0].area, building.rooms[1].area);
  EXPECT_NEAR(largest, 7.1 * 3.0, 1.0);
}

TEST(StationViews, TheOrderOfThePointsDoesNotMatter)
{
  const auto scene = threeRooms({fromBToC(0.9f)});
  const auto expected = roomsOf(scene, {{in_a, in_b}, {}});
  std::mt19937 rng(3);
  std::vector<std::size_t> order(scene.points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    std::swap(order[i] = i, order[rng() % (i + 1)]);
  test::LabelledPoints shuffled;
  for (const auto i : order)
    shuffled.points.push_back(scene.points[i]);
  const auto building = roomsOf(shuffled, {{in_a, in_b}, {}});
  ASSERT_EQ(building.rooms.size(), expected.rooms.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    EXPECT_EQ(building.point_labels[i] > 0, expected.point_labels[order[i]] > 0);
}

TEST(StationViews, StationsOfOtherPointsAreRefused)
{
  EXPECT_THROW(roomsOf(threeRooms(), {{in_a}, {1, 1, 1}}), pcl::BadArgumentException);
}
