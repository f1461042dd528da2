/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/object_steps.h"
#include "support/furnished_building.h"

#include <pcl/exceptions.h>
#include <pcl/segmentation/noise_resilient_lccp.h>
#include <pcl/segmentation/room_objects.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::indoor {
namespace {

using test::Building;
using test::cloudOf;
using test::room;

/** Points of a floor and a wall along x from 0 on, 5 cm apart; those before an end are
 * in room 1. */
struct Corridor {
  explicit Corridor(double length, double end)
  {
    for (double x = 0.0; x < length; x += 0.05)
      for (double across = 0.0; across < 1.0; across += 0.05) {
        const auto along = static_cast<float>(x), other = static_cast<float>(across);
        positions.emplace_back(along, other, 0.0f);
        positions.emplace_back(along, 1.0f, other);
        rooms.insert(rooms.end(), 2, x < end ? 1u : 0u);
      }
  }

  /** Where the points in a room end along x. */
  double
  endOf(const std::vector<std::uint32_t>& room_of_point) const
  {
    float end = 0.0f;
    for (std::size_t i = 0; i < positions.size(); ++i)
      if (room_of_point[i] > 0)
        end = std::max(end, positions[i].x());
    return end;
  }

  std::vector<Eigen::Vector3f> positions;
  std::vector<std::uint32_t> rooms;
};

} // namespace

TEST(RoomObjects, AreTheSegmentsOfTheRoomAlone)
{
  const Building building;
  const auto points = room(building, 1);
  ObjectSegmentationOptions options;
  options.fewest_points = 0;
  const auto objects = segmentRoomObjects(points, options);
  NoiseResilientLCCP<PointXYZ> segmentation;
  segmentation.setOptions(options);
  segmentation.setInputCloud(cloudOf(points.positions));
  std::vector<std::uint32_t> labels;
  segmentation.segment(labels);
  EXPECT_EQ(objects.object_of_point, labels);
  EXPECT_EQ(objects.structure_of_point, segmentation.getStructure());
  EXPECT_EQ(objects.voxel_size, stepsOf(segmentation.getResult()).scene.voxel_size);
  EXPECT_EQ(objects.surfaces.size(), *std::max_element(labels.begin(), labels.end()));
}

TEST(RoomObjects, TheVoterIsAskedWhereNoCeilingWasSeen)
{
  const Building building;
  const auto with_ceiling = room(building, 1);
  auto without = with_ceiling;
  without.normals.clear();
  float high = 0.0f;
  for (const auto& position : without.positions)
    high = std::max(high, position.z());
  auto& positions = without.positions;
  positions.erase(
      std::remove_if(positions.begin(),
                     positions.end(),
                     [&](const Eigen::Vector3f& p) { return p.z() > high - 0.3f; }),
      positions.end());
  const auto count = positions.size();
  for (std::size_t i = 0; i < count; ++i) // merged with itself
    positions.push_back(Eigen::Vector3f(positions[i]));
  positions.emplace_back(1e7f, 0.0f, 0.0f); // a stray
  std::size_t asked = 0;
  VoxelVoter voter;
  voter.classify = [&asked](const std::vector<Eigen::Vector3f>& points) {
    ++asked;
    VoxelClasses votes;
    votes.class_count = 4;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      votes.voxel_of_point.push_back(i);
      votes.probabilities.insert(votes.probabilities.end(), {0.1f, 0.1f, 0.1f, 0.7f});
      votes.to_middle.emplace_back(-points[i]);
    }
    return votes;
  };
  EXPECT_EQ(segmentRoomObjects(with_ceiling, {}, voter).votes.class_count, 0u);
  EXPECT_EQ(asked, 0u);
  const auto objects = segmentRoomObjects(without, {}, voter);
  EXPECT_EQ(asked, 1u);
  EXPECT_EQ(objects.votes.voxel_of_point.size(), positions.size());
  EXPECT_EQ(objects.votes.voxel_of_point[5], objects.votes.voxel_of_point[count + 5]);
  voter.in_all_rooms = true;
  EXPECT_EQ(segmentRoomObjects(with_ceiling, {}, voter).votes.class_count, 4u);
  auto given = without;
  given.given.assign(positions.size(), 1);
  EXPECT_EQ(segmentRoomObjects(given, {}, voter).votes.voxel_of_point.size(),
            positions.size());
  EXPECT_EQ(asked, 3u);
}

TEST(RoomObjects, SparsePointsAreSeenMoreFinelyWithVotes)
{
  const Building building;
  const auto points = room(building, 1);
  const auto alone = segmentRoomObjects(points);
  VoxelVoter voter;
  voter.in_all_rooms = true;
  voter.classify = [](const std::vector<Eigen::Vector3f>& positions) {
    VoxelClasses votes;
    votes.class_count = 4;
    votes.voxel_of_point.assign(positions.size(), 0);
    votes.probabilities = {0.0f, 0.0f, 0.0f, 1.0f};
    votes.to_middle.emplace_back(0.0f, 0.0f, 0.0f);
    return votes;
  };
  const auto voted = segmentRoomObjects(points, {}, voter);
  EXPECT_GT(alone.voxel_size, 0.05);
  EXPECT_NEAR(voted.voxel_size, 0.7 * alone.voxel_size, 1e-9);
  EXPECT_EQ(voted.object_of_point.size(), points.positions.size());
  ObjectSegmentationOptions given;
  given.voxel_size = 0.06;
  EXPECT_EQ(segmentRoomObjects(points, given, voter).voxel_size, 0.06);
  thesis::ObjectOptions lccp;
  lccp.edges.partition = thesis::EdgePartition::Lccp;
  EXPECT_EQ(thesis::segmentRoomObjects(points, lccp, voter).voxel_size,
            alone.voxel_size);
}

TEST(RoomObjects, AScanThatWasMergedWithItselfHasThoseOfTheScan)
{
  const Building building;
  const auto once = room(building, 1);
  const auto expected = segmentRoomObjects(once);
  const auto count = once.positions.size();
  for (const int copies : {2, 3, 5}) {
    RoomPoints points;
    for (int copy = 0; copy < copies; ++copy)
      points.positions.insert(
          points.positions.end(), once.positions.begin(), once.positions.end());
    const auto objects = segmentRoomObjects(points);
    ASSERT_EQ(objects.object_of_point.size(), copies * count);
    EXPECT_EQ(objects.voxel_size, expected.voxel_size);
    EXPECT_EQ(objects.surfaces.size(), expected.surfaces.size());
    for (std::size_t i = 0; i < objects.object_of_point.size(); ++i) {
      ASSERT_EQ(objects.object_of_point[i], expected.object_of_point[i % count]);
      ASSERT_EQ(objects.structure_of_point[i], expected.structure_of_point[i % count]);
    }
  }
}

TEST(RoomObjects, NormalsThatAreNoneAreEstimated)
{
  const Building building;
  auto points = room(building, 1);
  const auto expected = segmentRoomObjects(points).object_of_point;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Eigen::Vector3f& none : {Eigen::Vector3f(0, 0, 0),
                                      Eigen::Vector3f(nan, nan, nan),
                                      Eigen::Vector3f(0.6f, 0.3f, 0.2f),
                                      Eigen::Vector3f(0, 0, 255)}) {
    points.normals.assign(points.positions.size(), none);
    EXPECT_EQ(segmentRoomObjects(points).object_of_point, expected) << none.transpose();
  }
}

TEST(RoomObjects, SurroundingsAreHalfAMetreOfSurface)
{
  const Corridor corridor(6.0, 3.0);
  const auto found = withSurroundings(corridor.positions, corridor.rooms);
  EXPECT_NEAR(corridor.endOf(found), 3.5, 0.26); // whole cells
  for (std::size_t i = 0; i < found.size(); ++i)
    if (corridor.rooms[i] > 0) {
      ASSERT_EQ(found[i], 1u);
    }
  // what is nearer but does not hang together with the room is none of it
  auto apart = corridor;
  for (std::size_t i = 0; i < apart.positions.size(); ++i)
    if (apart.rooms[i] == 0)
      apart.positions[i].x() += 0.6f;
  EXPECT_EQ(withSurroundings(apart.positions, apart.rooms), apart.rooms);
}

TEST(RoomObjects, SurroundingsOfTwoRoomsAreThoseOfTheNearer)
{
  Corridor corridor(6.0, 2.5);
  for (std::size_t i = 0; i < corridor.positions.size(); ++i)
    if (corridor.positions[i].x() > 3.3f)
      corridor.rooms[i] = 2;
  const auto found = withSurroundings(corridor.positions, corridor.rooms);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const float x = corridor.positions[i].x();
    if (x < 2.6f || x > 3.2f) {
      EXPECT_EQ(found[i], x < 3.0f ? 1u : 2u) << x;
    }
    EXPECT_GT(found[i], 0u);
  }
  const std::vector<std::uint32_t> none(corridor.positions.size(), 0);
  EXPECT_EQ(withSurroundings(corridor.positions, none), none);
  EXPECT_TRUE(withSurroundings({}, {}).empty());
}

TEST(RoomObjects, APointKilometresAwayIsInNoneAndChangesNone)
{
  auto one = room(Building(), 1);
  const auto alone = segmentRoomObjects(one);
  one.positions.emplace_back(0.0f, 1e6f, 0.0f);
  one.given.assign(one.positions.size(), 1);
  one.given.back() = 2;
  const auto given = segmentRoomObjects(one);
  EXPECT_EQ(given.object_of_point.front(), 1u);
  EXPECT_EQ(given.object_of_point.back(), 0u);
  one.given.clear();
  auto objects = segmentRoomObjects(one).object_of_point;
  EXPECT_EQ(objects.back(), 0u);
  objects.pop_back();
  EXPECT_EQ(objects, alone.object_of_point);
}

TEST(RoomObjects, AreMeasuredInTheFrameThatIsAskedFor)
{
  const std::vector<Eigen::Vector3f> upright = {
      {0, 0, 0}, {2, 0, 0}, {9, 9, 9}, {2, 1, 0.5f}, {0, 1, 0.5f}};
  std::vector<Eigen::Vector3f> positions;
  for (const auto& point : upright)
    positions.emplace_back(1000.0f * point.z(), 1000.0f * point.x(), 7.0f);
  RoomObjects objects;
  objects.object_of_point = {1, 1, 0, 1, 1};
  objects.structure_of_point = {2, 2, 4, 2, 2};
  objects.surfaces.resize(1);
  const auto measures = measureObjects(positions, upright, objects);
  ASSERT_EQ(measures.size(), 1u);
  EXPECT_EQ(measures[0].structure, 2u);
  EXPECT_EQ(measures[0].point_count, 4u);
  EXPECT_EQ(measures[0].lower, Eigen::Vector3d(0, 0, 7));
  EXPECT_EQ(measures[0].upper, Eigen::Vector3d(500, 2000, 7));
  EXPECT_EQ(measures[0].centroid, Eigen::Vector3d(250, 1000, 7));
  EXPECT_TRUE(measures[0].upright.size.isApprox(Eigen::Vector3d(2, 1, 0.5), 1e-12));
  EXPECT_THROW(measureObjects(positions, {}, objects), BadArgumentException);
}

TEST(RoomObjects, WrongUseIsRefusedAndNothingGivesNothing)
{
  const auto nothing = segmentRoomObjects({});
  EXPECT_TRUE(nothing.object_of_point.empty());
  EXPECT_EQ(nothing.voxel_size, 0.0);
  const auto one = segmentRoomObjects({{{1, 2, 3}}, {}, {}});
  EXPECT_EQ(one.object_of_point, std::vector<std::uint32_t>{0}); // is the remainder
  EXPECT_EQ(one.structure_of_point[0],
            static_cast<std::uint32_t>(StructureKind::Remainder));
  const std::vector<Eigen::Vector3f> two(2, Eigen::Vector3f::UnitZ());
  EXPECT_THROW(segmentRoomObjects({two, {{0, 0, 1}}, {}}), BadArgumentException);
  EXPECT_THROW(segmentRoomObjects({two, {}, {1, 1, 1}}), BadArgumentException);
  EXPECT_THROW(pointsOfRooms(*cloudOf(two), {1}, 1), BadArgumentException);
  EXPECT_EQ(largestFirst({3, 9, 3, 20}), (std::vector<std::size_t>{3, 1, 0, 2}));
}

} // namespace pcl::indoor
