/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/scan_warnings.h>

#include <gtest/gtest.h>

#include <limits>

using namespace pcl::indoor;

namespace {

ScanSigns
upright(double height)
{
  ScanSigns signs;
  signs.free_length = {4.0 * height, 3.0 * height, height};
  signs.uprightness = {0.1, 0.1, 1.0};
  return signs;
}

bool
holds(const std::string& line, const std::string& part)
{
  return line.find(part) != std::string::npos;
}

std::vector<Room>
roomsOf(int count, double height)
{
  std::vector<Room> rooms(count);
  for (auto& room : rooms) {
    room.area = 20.0;
    room.height = height;
  }
  return rooms;
}

std::vector<RoomOpening>
doorsOf(int count, double height)
{
  std::vector<RoomOpening> doors(count);
  for (auto& door : doors) {
    door.width = 2.0;
    door.area = 2.0 * height;
  }
  return doors;
}

} // namespace

TEST(ScanWarnings, TheUnitIsNamed)
{
  EXPECT_TRUE(holds(unitWarning(upright(2500), 1.0), "(-unit mm)"));
  EXPECT_TRUE(holds(unitWarning(upright(250), 1.0), "(-unit cm)"));
  EXPECT_TRUE(holds(unitWarning(upright(98), 1.0), "(-unit in)"));
  EXPECT_TRUE(holds(unitWarning(upright(0.0025), 0.001), "(-unit m)"));
  for (const double height : {0.0, 0.4, 2.5, 8.2, 40.0})
    EXPECT_EQ(unitWarning(upright(height), 1.0), "") << height;
  EXPECT_EQ(unitWarning(upright(2.5), 0.001), "");
}

TEST(ScanWarnings, FeetShowInRoomsAndDoors)
{
  EXPECT_TRUE(holds(feetWarning(roomsOf(6, 8.2), doorsOf(5, 6.6), 1.0), "(-unit ft)"));
  EXPECT_EQ(feetWarning(roomsOf(6, 8.2), doorsOf(5, 2.0), 1.0), ""); // halls
  EXPECT_EQ(feetWarning(roomsOf(3, 8.2), doorsOf(5, 6.6), 1.0), ""); // a church
  EXPECT_EQ(feetWarning(roomsOf(6, 2.6), doorsOf(5, 2.0), 1.0), "");
  EXPECT_EQ(feetWarning(roomsOf(6, 8.2), doorsOf(5, 6.6), 0.3048), "");
  EXPECT_EQ(feetWarning({}, {}, 1.0), "");
  auto mixed = roomsOf(6, 8.2);
  mixed.back().area = 200.0;
  mixed.back().height = 4.0;
  EXPECT_EQ(feetWarning(mixed, doorsOf(5, 6.6), 1.0), "");
}

TEST(ScanWarnings, TheAxisIsThatOfTheCloud)
{
  ScanSigns signs = upright(2.5);
  EXPECT_EQ(axisWarning(signs, Eigen::Matrix3d::Identity()), "");
  signs.uprightness = {0.1, 1.0, 0.1};
  EXPECT_TRUE(holds(axisWarning(signs, Eigen::Matrix3d::Identity()), "-up y,"));
  Eigen::Matrix3d turn; // y of the building is x of the cloud
  turn << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  EXPECT_TRUE(holds(axisWarning(signs, turn), "-up x,"));
  signs.uprightness = {0.1, 0.13, 0.1}; // not clearly
  EXPECT_EQ(axisWarning(signs, turn), "");
  EXPECT_EQ(axisWarning({}, turn), "");
}

TEST(ScanWarnings, StepsOfFloats)
{
  EXPECT_EQ(floatStep(5.8e6), 0.5);
  EXPECT_EQ(floatStep(-4.5e5), 0.03125);
  EXPECT_TRUE(holds(stepWarning(0.5, 0.0), "steps of 0.5 m"));
  EXPECT_TRUE(holds(stepWarning(0.5, 0.0), "voxels of 0.1 m"));
  EXPECT_EQ(stepWarning(0.5, 0.5), "");
  EXPECT_EQ(stepWarning(0.03125, 0.0), "");
}

TEST(ScanWarnings, ManyPointsLeftOut)
{
  EXPECT_EQ(outsideWarning(0, 0), "");
  EXPECT_EQ(outsideWarning(9, 100), "");
  EXPECT_TRUE(holds(outsideWarning(10, 100), "10 of 100 points"));
}
