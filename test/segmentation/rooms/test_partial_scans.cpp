/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/building_steps.h"
#include "support/synthetic_scenes.h"

#include <pcl/segmentation/building_rooms.h>
#include <pcl/segmentation/scan_warnings.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl::indoor;
using test::LabelledPoints;
using Points = std::vector<Eigen::Vector3f>;

namespace {

/** Two rooms of 2.5 m, of which only the points that a test takes were seen. */
template <typename Seen>
Points
partOfTwoRooms(const Seen& seen)
{
  Points points = test::twoRooms().points;
  points.erase(std::remove_if(points.begin(),
                              points.end(),
                              [&](const auto& p) { return !seen(p.z()); }),
               points.end());
  return points;
}

bool
isFloorHeight(float z)
{
  return z < 0.03f;
}

bool
isCeilingHeight(float z)
{
  return z > 2.47f;
}

/** Two rooms of the right size and height, and one line that names what is missing. */
void
expectTwoRooms(const Points& points, const std::string& missing)
{
  const auto building = segmentBuilding(points);
  ASSERT_EQ(building.rooms.size(), 2u) << missing;
  EXPECT_NEAR(building.rooms[0].area, 12.0, 0.6) << missing;
  EXPECT_NEAR(building.rooms[1].area, 9.0, 1.0) << missing; // behind the cabinet, too
  for (const Room& room : building.rooms)
    EXPECT_NEAR(room.height, 2.5, 0.1) << missing;
  EXPECT_EQ(building.openings.size(), 1u) << missing;
  const auto warnings = unseenWarnings(building);
  if (missing.empty()) {
    EXPECT_TRUE(warnings.empty());
    return;
  }
  ASSERT_EQ(warnings.size(), 1u) << missing;
  EXPECT_NE(warnings[0].find(missing), std::string::npos) << warnings[0];
}

void
addGround(float reach, float spacing, Points& points)
{
  std::mt19937 rng(3);
  LabelledPoints ground;
  ground.addRectangle({-reach, -reach, -0.1f},
                      {7.1f + 2 * reach, 0, 0},
                      {0, 3 + 2 * reach, 0},
                      {0, 0, 1},
                      0,
                      spacing,
                      0.01f,
                      rng);
  for (const auto& point : ground.points) // none below the house
    if (point.x() < -0.2f || point.x() > 7.3f || point.y() < -0.2f || point.y() > 3.2f)
      points.push_back(point);
}

} // namespace

TEST(PartialScans, WholeScansAreSaidToBeWhole)
{
  expectTwoRooms(test::twoRooms().points, "");
}

TEST(PartialScans, WithoutFloors)
{
  expectTwoRooms(partOfTwoRooms([](float z) { return !isFloorHeight(z); }),
                 "No floors");
}

TEST(PartialScans, WithoutCeilings)
{
  expectTwoRooms(partOfTwoRooms([](float z) { return !isCeilingHeight(z); }),
                 "No ceilings");
}

/** A hall, 12 x 9 m, of which nothing above 1.6 m was seen, nor the floor between two
 * lengths, and a room beside it, 8 x 9 m, that was seen whole. */
void
expectAHallSeenToTheShoulders(float unseen_begin, float unseen_end)
{
  auto points =
      test::rooms({{{0, 0, 0}, {12, 9, 2.5f}, 1}, {{12.1f, 0, 0}, {20, 9, 2.5f}, 2}},
                  {test::doorway(11.95f, 12.15f, 4.0f, 5.0f, 2.0f)})
          .points;
  const auto is_unseen = [&](const auto& p) {
    return (p.x() < 12.05f && p.z() > 1.6f) ||
           (isFloorHeight(p.z()) && p.x() > unseen_begin && p.x() < unseen_end);
  };
  points.erase(std::remove_if(points.begin(), points.end(), is_unseen), points.end());
  const auto building = segmentBuilding(points);
  const auto& unseen = stepsOf(building).interior.unseen;
  EXPECT_TRUE(unseen.ceilingIsSeen());
  EXPECT_FALSE(unseen.ceilingIsMostlySeen());
  ASSERT_EQ(building.rooms.size(), 2u);
  EXPECT_NEAR(building.rooms[0].area, 108.0, 4.0);
  EXPECT_NEAR(building.rooms[1].area, 71.1, 3.0);
}

TEST(PartialScans, AHallSeenToTheShouldersBesideARoomWithACeiling)
{
  expectAHallSeenToTheShoulders(0, 0);
}

TEST(PartialScans, AHallSeenToTheShouldersWithoutAPartOfItsFloor)
{
  expectAHallSeenToTheShoulders(5, 8);
}

TEST(PartialScans, WallsThatAreSeenToTheShouldersAloneDivideRooms)
{
  const auto is_seen = [](const Eigen::Vector3f& p) {
    const bool is_between = p.x() > 3.9f && p.x() < 4.2f;
    return p.z() < (is_between ? 1.6f : p.x() < 2.0f ? 2.2f : 1.85f);
  };
  Points points;
  for (const auto& point : test::twoRooms().points)
    if (is_seen(point))
      points.push_back(point);
  const auto building = segmentBuilding(points);
  ASSERT_EQ(building.rooms.size(), 2u);
  EXPECT_NEAR(building.rooms[0].area, 12.0, 0.6);
  ASSERT_EQ(building.openings.size(), 1u);
  // nothing tells that the passage ends at the ceiling
  EXPECT_LE(building.openings[0].rise, 0.0);
  EXPECT_EQ(endOfPassages(building.openings), 0);
}

/** Two rooms of 6 x 5 m with a passage of a metre between them, of which nothing above
 * 1.6 m was seen beyond a third of their length, but for the walls around them. */
Points
twoRoomsSeenUpToTheirCeilingsInParts()
{
  auto points =
      test::rooms({{{0, 0, 0}, {6, 5, 2.5f}, 1}, {{6.1f, 0, 0}, {12, 5, 2.5f}, 2}},
                  {test::doorway(5.95f, 6.15f, 4.0f, 5.0f, 2.0f)})
          .points;
  points.erase(std::remove_if(points.begin(),
                              points.end(),
                              [&](const auto& p) {
                                return p.y() > 1.7f && p.z() > 1.6f && p.y() < 4.9f &&
                                       p.x() > 0.1f && p.x() < 11.9f;
                              }),
               points.end());
  return points;
}

TEST(PartialScans, AWallThatReachesUpInPartsDividesRooms)
{
  const auto building = segmentBuilding(twoRoomsSeenUpToTheirCeilingsInParts());
  EXPECT_TRUE(stepsOf(building).interior.unseen.ceilingIsSeen());
  EXPECT_FALSE(stepsOf(building).interior.unseen.ceilingIsMostlySeen());
  ASSERT_EQ(building.rooms.size(), 2u);
  EXPECT_NEAR(building.rooms[0].area, 30.0, 1.5);
  EXPECT_NEAR(building.rooms[1].area, 29.5, 1.5);
  ASSERT_EQ(building.openings.size(), 1u);
}

TEST(PartialScans, PassagesUpToCeilingsSeenInPartsDoNotHang)
{
  auto points = twoRoomsSeenUpToTheirCeilingsInParts();
  LabelledPoints step; // in the passage
  std::mt19937 rng(1);
  step.addBox({5.95f, 4.0f, 0.0f}, {0.2f, 1.0f, 0.4f}, 0, 0.02f, 0.0f, rng);
  points.insert(points.end(), step.points.begin(), step.points.end());
  const auto building = segmentBuilding(points);
  ASSERT_EQ(building.openings.size(), 1u);
  EXPECT_LE(building.openings[0].rise, 0.0);
}

/** A hall with a ceiling, 16 x 12 m, and rooms along it, of which nothing above 1.6 m
 * was seen, nor the lintels between. */
TEST(PartialScans, PassagesToRoomsWithoutCeilingsBesideAHallDoNotHang)
{
  auto points = test::rooms({{{0, 0, 0}, {16, 12, 2.5f}, 1},
                             {{16.1f, 0, 0}, {20, 6, 2.5f}, 2},
                             {{16.1f, 6.1f, 0}, {20, 12, 2.5f}, 3}},
                            {test::doorway(15.95f, 16.15f, 2.0f, 3.0f, 2.0f),
                             test::doorway(15.95f, 16.15f, 8.0f, 9.0f, 2.0f)})
                    .points;
  LabelledPoints steps; // in the passages
  std::mt19937 rng(1);
  for (const float y : {2.0f, 8.0f})
    steps.addBox({15.95f, y, 0.0f}, {0.2f, 1.0f, 0.4f}, 0, 0.02f, 0.0f, rng);
  points.insert(points.end(), steps.points.begin(), steps.points.end());
  const auto is_lintel = [](const auto& p, float y) {
    return p.x() > 15.9f && p.y() > y && p.y() < y + 1.0f && p.z() > 1.6f;
  };
  points.erase(std::remove_if(points.begin(),
                              points.end(),
                              [&](const auto& p) {
                                return is_lintel(p, 2.0f) || is_lintel(p, 8.0f) ||
                                       (p.x() > 16.2f && p.x() < 19.9f && p.z() > 1.6f);
                              }),
               points.end());
  const auto building = segmentBuilding(points);
  EXPECT_TRUE(stepsOf(building).interior.unseen.ceilingIsMostlySeen());
  EXPECT_FALSE(building.openings.empty());
  for (const RoomOpening& opening : building.openings)
    EXPECT_LE(opening.rise, 0.0);
}

TEST(PartialScans, WallsAlone)
{
  expectTwoRooms(
      partOfTwoRooms([](float z) { return !isFloorHeight(z) && !isCeilingHeight(z); }),
      "Neither floors nor ceilings");
}

TEST(PartialScans, WithoutWallsTheBordersOfRoomsAreDoubted)
{
  const auto building = segmentBuilding(
      partOfTwoRooms([](float z) { return isFloorHeight(z) || isCeilingHeight(z); }));
  ASSERT_FALSE(building.rooms.empty());
  const auto warnings = unseenWarnings(building);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("Walls were seen on only"), std::string::npos);
}

TEST(PartialScans, ABlockBetweenCorridorsIsNoPlaceWithoutCeiling)
{
  const std::vector<test::RoomBox> ring = {{{0, 0, 0}, {12, 1.6f, 2.5f}, 1},
                                           {{0, 8.4f, 0}, {12, 10, 2.5f}, 1},
                                           {{0, 1.7f, 0}, {1.6f, 8.3f, 2.5f}, 1},
                                           {{10.4f, 1.7f, 0}, {12, 8.3f, 2.5f}, 1}};
  std::vector<test::Opening> corners;
  for (const float x : {0.05f, 10.45f})
    for (const float y : {1.55f, 8.25f})
      corners.push_back(test::junction(x, x + 1.5f, y, y + 0.2f));
  auto points = test::rooms(ring, corners).points; // half of the ceiling, no floor
  points.erase(std::remove_if(points.begin(),
                              points.end(),
                              [](const auto& p) {
                                return isFloorHeight(p.z()) ||
                                       (isCeilingHeight(p.z()) &&
                                        (p.x() > 1.7f && p.y() > 1.7f));
                              }),
               points.end());
  const auto unseen = stepsOf(segmentBuilding(points)).interior.unseen;
  EXPECT_FALSE(unseen.floorIsSeen());
  EXPECT_TRUE(unseen.ceilingIsSeen()) << unseen.ceiling_seen;
}

TEST(PartialScans, WhatIsSeenThroughADoorIsNoRoom)
{
  auto points = test::twoRooms().points;
  const auto whole = segmentBuilding(points);
  ASSERT_EQ(whole.rooms.size(), 2u);
  EXPECT_EQ(whole.hardly_seen, 0u);
  // of the second room, floor and ceiling at the door, and no wall but the door's
  points.erase(std::remove_if(points.begin(),
                              points.end(),
                              [](const auto& p) {
                                const bool is_level =
                                    isFloorHeight(p.z()) || isCeilingHeight(p.z());
                                const bool is_near =
                                    p.x() < 5.2f && std::abs(p.y() - 1.5f) < 0.9f;
                                return p.x() > 4.3f && !(is_level && is_near);
                              }),
               points.end());
  const auto seen = segmentBuilding(points);
  ASSERT_EQ(seen.rooms.size(), 1u);
  EXPECT_NEAR(seen.rooms[0].area, whole.rooms[0].area, 0.6);
  EXPECT_EQ(seen.hardly_seen, 1u);
}

TEST(PartialScans, FlagsTellWhichRoomsLackWhat)
{
  const auto building =
      segmentBuilding(partOfTwoRooms([](float z) { return !isFloorHeight(z); }));
  for (const Room& room : building.rooms) {
    EXPECT_EQ(room.floor_seen, 0.0);
    EXPECT_GT(room.ceiling_seen, 0.9);
  }
}

TEST(PartialScans, SlicesAndFlatMapsHaveNoRooms)
{
  const auto slice =
      segmentBuilding(partOfTwoRooms([](float z) { return z > 0.9f && z < 1.3f; }));
  Points flat = partOfTwoRooms([](float z) { return z > 0.9f && z < 1.0f; });
  for (auto& point : flat)
    point.z() = 0.0f;
  for (const auto& building : {slice, segmentBuilding(flat)}) {
    EXPECT_TRUE(building.rooms.empty());
    const auto warnings = unseenWarnings(building);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("there are no rooms"), std::string::npos);
  }
}

TEST(PartialScans, GroundAroundAHouseIsNoRoom)
{
  Points points = test::twoRooms().points;
  addGround(12.0f, 0.3f, points);
  const auto building = segmentBuilding(points);
  EXPECT_EQ(building.grid.voxel_size, 0.1); // not that of the ground
  ASSERT_EQ(building.rooms.size(), 2u);
  EXPECT_NEAR(building.rooms[0].area, 12.0, 0.6);
  EXPECT_TRUE(unseenWarnings(building).empty());
}

TEST(PartialScans, SpacesThatWereHardlySeenAreNoRooms)
{
  Points points = test::twoRooms().points;
  std::mt19937 rng(4);
  const auto image = // behind the wall at x = 0, with a twelfth of the points
      test::rooms({{{-4.2f, 0, 0}, {-0.2f, 3, 2.5f}, 1}}, {}, 0.04f, 0.01f).points;
  for (const auto& point : image)
    if (rng() % 12 == 0)
      points.push_back(point);
  const auto building = segmentBuilding(points);
  EXPECT_EQ(building.rooms.size(), 2u);
  EXPECT_EQ(building.hardly_seen, 1u);
  ASSERT_EQ(unseenWarnings(building).size(), 1u);
  EXPECT_NE(unseenWarnings(building)[0].find("no room"), std::string::npos);
}
