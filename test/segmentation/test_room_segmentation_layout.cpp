/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

// Openings, footprints, the up axis, and progress of pcl::RoomSegmentation.

#include "support/room_labels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace pcl::indoor::test;
using RoomSegmentationXYZ = pcl::RoomSegmentation<pcl::PointXYZ>;

namespace {

RoomSegmentationXYZ
segmentationAlong(const std::vector<Eigen::Vector3f>& points,
                  Labels& labels,
                  const Eigen::Vector3f& up = Eigen::Vector3f::UnitZ())
{
  RoomSegmentationXYZ result;
  result.setInputCloud(cloudOf(points));
  result.setUpAxis(up);
  result.segment(labels);
  return result;
}

/** Area within a closed line in a plane with the given normal. */
double
areaOf(const std::vector<Eigen::Vector3d>& line, const Eigen::Vector3d& normal)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < line.size(); ++i)
    sum += (line[i] - line[0]).cross(line[(i + 1) % line.size()] - line[0]);
  return 0.5 * sum.dot(normal);
}

/** A turn that takes z to the given axis and exchanges coordinates only. */
Eigen::Matrix3f
turnTo(const Eigen::Vector3f& up)
{
  Eigen::Matrix3f turn;
  turn.col(0) = Eigen::Vector3f(1.0f - std::abs(up.x()), std::abs(up.x()), 0);
  turn.col(2) = up;
  turn.col(1) = up.cross(Eigen::Vector3f(turn.col(0)));
  return turn;
}

} // namespace

TEST(RoomSegmentationLayout, TheDoorIsAnOpening)
{
  Labels labels;
  const auto result = segmentationAlong(twoRooms().points, labels);
  const auto door = doorOfTwoRooms();
  ASSERT_EQ(result.getOpenings().size(), 1u);
  const auto& opening = result.getOpenings()[0];
  EXPECT_EQ(opening.room_a, 1u);
  EXPECT_EQ(opening.room_b, 2u);
  const double size = result.getReport().voxel_size;
  const double spacing = 0.04; // of the points: the posts begin up to that much later
  EXPECT_NEAR(opening.position.x(), door.center().x(), size);
  EXPECT_NEAR(opening.position.y(), door.center().y(), spacing);
  EXPECT_NEAR(opening.position.z(), 0.0, size);
  EXPECT_NEAR(opening.width, door.sizes().y(), 2 * spacing);
  EXPECT_NEAR(opening.area, opening.width * door.max().z(), 2 * size * opening.width);
}

TEST(RoomSegmentationLayout, ARectangularRoomHasFourCorners)
{
  Labels labels;
  const auto result = segmentationAlong(twoRooms().points, labels);
  ASSERT_EQ(result.getRooms().size(), 2u);
  for (const auto& room : result.getRooms()) {
    ASSERT_EQ(room.footprint.size(), 1u);
    EXPECT_EQ(room.footprint[0].size(), 4u);
    // a pixel at each corner
    EXPECT_NEAR(areaOf(room.footprint[0], Eigen::Vector3d::UnitZ()), room.area, 0.041);
    for (const auto& corner : room.footprint[0]) {
      EXPECT_GT(corner.x(), room.lower.x() - 0.01);
      EXPECT_LT(corner.x(), room.upper.x() + 0.01);
      EXPECT_GT(corner.y(), room.lower.y() - 0.01);
      EXPECT_LT(corner.y(), room.upper.y() + 0.01);
      EXPECT_NEAR(corner.z(), 0.0, result.getReport().voxel_size);
    }
  }
}

TEST(RoomSegmentationLayout, AnyAxisMayPointUp)
{
  const auto points = bentCorridorWithThreeRooms().points;
  Labels labels;
  const auto upright = segmentationAlong(points, labels);
  ASSERT_EQ(roomCount(labels), 4u);
  ASSERT_EQ(upright.getOpenings().size(), bentCorridorDoors().size());
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {-1.0f, 1.0f}) {
      const Eigen::Vector3f up = sign * Eigen::Vector3f::Unit(axis);
      const Eigen::Matrix3f turn = turnTo(up);
      ASSERT_NEAR(turn.determinant(), 1.0f, 1e-6f);
      std::vector<Eigen::Vector3f> lying;
      for (const auto& point : points)
        lying.push_back(turn * point);
      Labels lying_labels;
      const auto result = segmentationAlong(lying, lying_labels, 3.0f * up);
      EXPECT_EQ(lying_labels, labels);
      ASSERT_EQ(result.getOpenings().size(), upright.getOpenings().size());
      for (std::size_t i = 0; i < upright.getOpenings().size(); ++i) {
        const Eigen::Vector3d expected =
            turn.cast<double>() * upright.getOpenings()[i].position;
        EXPECT_LT((result.getOpenings()[i].position - expected).norm(), 1e-9);
      }
      ASSERT_EQ(result.getRooms().size(), 4u);
      for (const auto& room : result.getRooms()) {
        Eigen::AlignedBox3d box;
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < lying.size(); ++i)
          if (lying_labels[i] == room.label) {
            box.extend(lying[i].cast<double>());
            sum += lying[i].cast<double>();
          }
        EXPECT_EQ(room.lower, box.min());
        EXPECT_EQ(room.upper, box.max());
        EXPECT_LT((room.centroid - sum / room.point_count).norm(), 1e-5);
        EXPECT_NEAR(areaOf(room.footprint.at(0), up.cast<double>()), room.area, 0.1);
      }
    }
}

TEST(RoomSegmentationLayout, ADirectionBetweenTheAxesMayPointUp)
{
  const auto scene = twoRooms();
  const Eigen::Matrix3f turn =
      Eigen::Quaternionf::FromTwoVectors(Eigen::Vector3f::UnitZ(),
                                         Eigen::Vector3f(0.3f, -0.5f, 0.4f))
          .toRotationMatrix();
  std::vector<Eigen::Vector3f> lying;
  for (const auto& point : scene.points)
    lying.push_back(turn * point);
  Labels labels;
  const auto result = segmentationAlong(lying, labels, turn.col(2));
  EXPECT_EQ(roomCount(labels), 2u);
  // where walls meet, the map's pixels decide, as for a turned building
  EXPECT_LT(wrongPoints(scene, labels, {doorOfTwoRooms()}), labels.size() / 200);
  ASSERT_EQ(result.getOpenings().size(), 1u);
  const Eigen::Vector3f door = doorOfTwoRooms().center();
  const Eigen::Vector3f on_floor(door.x(), door.y(), 0.0f);
  EXPECT_LT((result.getOpenings()[0].position.cast<float>() - turn * on_floor).norm(),
            0.2f); // two voxels
}

TEST(RoomSegmentationLayout, ProgressRisesFromZeroToOne)
{
  RoomSegmentationXYZ segmentation;
  segmentation.setInputCloud(cloudOf(twoRooms().points));
  std::vector<double> shares;
  segmentation.setProgressCallback([&](double share, const char* stage) {
    shares.push_back(share);
    EXPECT_FALSE(std::string(stage).empty());
    return true;
  });
  Labels labels;
  segmentation.segment(labels);
  EXPECT_EQ(roomCount(labels), 2u);
  ASSERT_GE(shares.size(), 5u);
  EXPECT_EQ(shares.front(), 0.0);
  EXPECT_EQ(shares.back(), 1.0);
  for (std::size_t i = 1; i < shares.size(); ++i)
    EXPECT_GT(shares[i], shares[i - 1]);
}

TEST(RoomSegmentationLayout, PointsMayBeElsewhereFromTheFirstCallOfProgressToTheLast)
{
  const auto cloud = cloudOf(twoRooms().points);
  const auto all = cloud->points;
  Labels expected, labels;
  RoomSegmentationXYZ segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.segment(expected);
  segmentation.setProgressCallback([&](double share, const char*) {
    if (share == 0.0)
      cloud->points.clear();
    if (share == 1.0)
      cloud->points = all;
    return true;
  });
  segmentation.segment(labels);
  EXPECT_EQ(roomCount(labels), 2u);
  EXPECT_EQ(labels, expected);
}

TEST(RoomSegmentationLayout, TheBuildingCanBeTakenAndTheRoomsStay)
{
  RoomSegmentationXYZ segmentation;
  segmentation.setInputCloud(cloudOf(twoRooms().points));
  Labels labels;
  segmentation.segment(labels);
  const std::size_t rooms = segmentation.getBuilding().rooms.size();
  const auto building = segmentation.takeBuilding();
  EXPECT_EQ(building.rooms.size(), rooms);
  EXPECT_EQ(building.maps.size(), 1u);
  EXPECT_EQ(segmentation.getRooms().size(), rooms);
  EXPECT_TRUE(segmentation.getBuilding().rooms.empty());
  EXPECT_TRUE(segmentation.getBuilding().maps.empty());
  EXPECT_TRUE(segmentation.takeBuilding().maps.empty());
}

TEST(RoomSegmentationLayout, WhatIsCancelledLeavesNothingAndCanBeRunAgain)
{
  RoomSegmentationXYZ segmentation;
  segmentation.setInputCloud(cloudOf(twoRooms().points));
  Labels all;
  segmentation.segment(all);
  for (const double limit : {0.0, 0.3, 0.7, 1.0}) {
    segmentation.setProgressCallback(
        [&](double share, const char*) { return share < limit; });
    Labels labels{7};
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    segmentation.segment(labels);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_TRUE(labels.empty()) << limit;
    EXPECT_TRUE(segmentation.getRooms().empty());
    EXPECT_TRUE(segmentation.getOpenings().empty());
    EXPECT_TRUE(segmentation.getBuilding().maps.empty());
    std::vector<pcl::PointIndices> rooms(3);
    segmentation.segment(rooms);
    EXPECT_TRUE(rooms.empty());
    segmentation.setProgressCallback({});
    segmentation.segment(labels);
    EXPECT_EQ(labels, all) << limit;
  }
}
