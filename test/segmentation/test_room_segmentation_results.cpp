/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/room_labels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace pcl::indoor::test;
using RoomSegmentationXYZ = pcl::RoomSegmentation<pcl::PointXYZ>;

namespace {

/** Two rooms on a raster of 1 / 1024 m, which floats hold exactly up to 16 km. */
std::vector<Eigen::Vector3f>
rasteredRooms()
{
  auto points = twoRooms().points;
  for (auto& point : points)
    point = (point * 1024.0f).array().round() / 1024.0f;
  return points;
}

} // namespace

TEST(RoomSegmentation, TwoRoomsWithADoorAreTwoRooms)
{
  const auto scene = twoRooms();
  const auto labels = segmented(cloudOf(scene.points));
  ASSERT_EQ(labels.size(), scene.points.size());
  EXPECT_EQ(roomCount(labels), 2u);
  EXPECT_EQ(wrongPoints(scene, labels, {doorOfTwoRooms()}), 0u);
}

TEST(RoomSegmentation, AWardrobeBesideAWallStaysInItsRoom)
{
  auto scene = twoRooms();
  std::mt19937 rng(3);
  // Its top lies as high as the slab in which walls are looked for.
  scene.addBox({3.4f, 0.3f, 0}, {0.58f, 0.5f, 2.2f}, 1, 0.03f, 0.005f, rng);
  const auto labels = segmented(cloudOf(scene.points));
  ASSERT_EQ(labels.size(), scene.points.size());
  EXPECT_EQ(roomCount(labels), 2u);
  // Between the corner and the wardrobe's side, the map's pixels of 10 cm decide.
  EXPECT_LT(wrongPoints(scene, labels, {doorOfTwoRooms()}), labels.size() / 100);
}

TEST(RoomSegmentation, ATurnedBuildingHasTheSameRooms)
{
  const auto scene = twoRooms();
  for (const double degrees : {17.0, 45.0, -80.0}) {
    const auto labels = segmented(cloudOf(turned(scene.points, degrees * M_PI / 180)));
    ASSERT_EQ(labels.size(), scene.points.size());
    EXPECT_EQ(roomCount(labels), 2u) << degrees;
    // Where walls meet, the map's pixels of 10 cm decide: at the four corners of the
    // wall between the rooms these are at most 0.5 % of all points.
    EXPECT_LT(wrongPoints(scene, labels, {doorOfTwoRooms()}), labels.size() / 200)
        << degrees;
  }
}

TEST(RoomSegmentation, ABentCorridorIsOneRoomBesideThreeRooms)
{
  const auto scene = bentCorridorWithThreeRooms();
  const auto labels = segmented(cloudOf(scene.points));
  ASSERT_EQ(labels.size(), scene.points.size());
  EXPECT_EQ(roomCount(labels), 4u);
  // As above, with eight corners and T-junctions: 2 % of all points.
  EXPECT_LT(wrongPoints(scene, labels, bentCorridorDoors()), labels.size() / 50);
}

TEST(RoomSegmentation, RoomsAreDescribedAsTheyAre)
{
  const auto scene = twoRooms();
  RoomSegmentationXYZ segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  Labels labels;
  segmentation.segment(labels);
  const auto& rooms = segmentation.getRooms();
  ASSERT_EQ(rooms.size(), 2u);
  const double size = segmentation.getReport().voxel_size;
  for (std::size_t r = 0; r < 2; ++r) {
    const auto& room = rooms[r];
    const double x0 = r == 0 ? 0.0 : 4.1, width = r == 0 ? 4.0 : 3.0;
    EXPECT_EQ(room.label, r + 1); // map pixels are numbered from small x on
    EXPECT_EQ(room.storey, 0u);
    EXPECT_EQ(
        room.point_count,
        static_cast<std::size_t>(std::count(labels.begin(), labels.end(), room.label)));
    EXPECT_NEAR(room.area, width * 3.0, 0.005 * width * 3.0);
    EXPECT_NEAR(room.height, 2.5, 2 * size);
    EXPECT_NEAR(room.lower.x(), x0, 0.11);   // points in the doorway
    EXPECT_NEAR(room.lower.y(), 0.0, 0.006); // noise
    EXPECT_NEAR(room.lower.z(), 0.0, 0.006);
    EXPECT_NEAR(room.upper.x(), x0 + width, 0.11);
    EXPECT_NEAR(room.upper.y(), 3.0, 0.006);
    EXPECT_NEAR(room.upper.z(), 2.5, 0.006);
    EXPECT_TRUE((room.lower.array() < room.centroid.array()).all());
    EXPECT_TRUE((room.upper.array() > room.centroid.array()).all());
  }
}

TEST(RoomSegmentation, OffsetsThatFloatsHoldChangeNothing)
{
  const auto points = rasteredRooms();
  const Eigen::Vector3f offset(8192, -4096, 512);
  std::vector<Eigen::Vector3f> moved;
  for (const auto& point : points) {
    moved.push_back(point + offset);
    ASSERT_EQ(moved.back() - offset, point);
  }
  const auto labels = segmented(cloudOf(points));
  EXPECT_EQ(roomCount(labels), 2u);
  EXPECT_EQ(segmented(cloudOf(moved)), labels);
}

TEST(RoomSegmentation, UtmCoordinatesLoseNoMoreThanTheirFloats)
{
  const Eigen::Vector3f offset(500000, 5000000, 0);
  std::vector<Eigen::Vector3f> far, near;
  for (const auto& point : twoRooms().points) {
    far.push_back(point + offset);       // y is rounded to half metres here
    near.push_back(far.back() - offset); // exact
  }
  RoomSegmentationXYZ segmentation;
  segmentation.setInputCloud(cloudOf(far));
  segmentation.setVoxelSize(0.2);
  Labels far_labels, near_labels;
  segmentation.segment(far_labels);
  segmentation.setInputCloud(cloudOf(near));
  segmentation.segment(near_labels);
  EXPECT_EQ(far_labels.size(), far.size());
  EXPECT_EQ(far_labels, near_labels);
}

TEST(RoomSegmentation, RoomsAndOriginAreInTheFrameOfTheInput)
{
  const Eigen::Vector3f offset(8192, -4096, 512);
  std::vector<Eigen::Vector3f> moved;
  for (const auto& point : rasteredRooms())
    moved.push_back(point + offset);
  RoomSegmentationXYZ segmentation;
  segmentation.setInputCloud(cloudOf(moved));
  Labels labels;
  segmentation.segment(labels);
  ASSERT_EQ(segmentation.getRooms().size(), 2u);
  for (const auto& room : segmentation.getRooms()) {
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < moved.size(); ++i)
      if (labels[i] == room.label)
        box.extend(moved[i].cast<double>());
    EXPECT_EQ(room.lower, box.min());
    EXPECT_EQ(room.upper, box.max());
  }
  // near the points, so that floats hold the points beside it
  EXPECT_LT((segmentation.getBuildingFrame().pose.translation() - offset.cast<double>())
                .norm(),
            10.0);
}

TEST(RoomSegmentation, WithoutACloudTheFrameIsNotThatOfTheLastOne)
{
  std::vector<Eigen::Vector3f> moved;
  for (const auto& point : rasteredRooms())
    moved.push_back(point + Eigen::Vector3f(8192, -4096, 512));
  RoomSegmentationXYZ segmentation;
  segmentation.setInputCloud(cloudOf(moved));
  Labels labels;
  segmentation.segment(labels);
  EXPECT_GT(segmentation.getBuildingFrame().pose.translation().norm(), 1.0);
  segmentation.setInputCloud(nullptr);
  segmentation.segment(labels);
  EXPECT_TRUE(labels.empty());
  EXPECT_EQ(segmentation.getBuildingFrame().pose.translation().norm(), 0.0);
}

TEST(RoomSegmentation, AFloorOrAWallAloneDoesNotCrash)
{
  std::mt19937 rng(3);
  LabelledPoints floor, wall;
  floor.addRectangle({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 1}, 1, 0.05f, 0.0f, rng);
  wall.addRectangle({0, 0, 0}, {3, 0, 0}, {0, 0, 3}, {0, 1, 0}, 1, 0.05f, 0.0f, rng);
  EXPECT_EQ(segmented(cloudOf(floor.points)).size(), floor.points.size());
  EXPECT_EQ(segmented(cloudOf(wall.points)).size(), wall.points.size());
}

TEST(RoomSegmentation, AllOutputsAreAlike)
{
  const auto cloud = cloudOf(twoRooms().points);
  RoomSegmentationXYZ segmentation;
  segmentation.setInputCloud(cloud);
  Labels labels;
  segmentation.segment(labels);
  std::vector<pcl::PointIndices> rooms;
  segmentation.segment(rooms);
  ASSERT_EQ(rooms.size(), 2u);
  for (std::size_t r = 0; r < rooms.size(); ++r)
    for (const auto index : rooms[r].indices)
      ASSERT_EQ(labels[index], r + 1);
  pcl::PointCloud<pcl::PointXYZL> output;
  segmentation.segment(output);
  ASSERT_EQ(output.size(), labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
    ASSERT_EQ(output[i].label, labels[i]);
  segmentation.setInputCloud(nullptr);
  segmentation.segment(output);
  EXPECT_TRUE(output.empty());
  segmentation.segment(rooms);
  EXPECT_TRUE(rooms.empty());
}
