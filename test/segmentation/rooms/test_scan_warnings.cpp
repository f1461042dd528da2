/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/scan_warnings.h>

#include <gtest/gtest.h>

#include <limits>

using namespace pcl::indoor;

namespace {

Vertical
upright(double height)
{
  Vertical vertical;
  vertical.is_found = vertical.is_end_known = vertical.has_rooms = true;
  vertical.room_height = height;
  return vertical;
}

Vertical
along(const Eigen::Vector3f& direction)
{
  Vertical vertical = upright(2.5);
  vertical.direction = direction.normalized();
  return vertical;
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
  EXPECT_TRUE(holds(unitWarning(upright(2.5), 0.001), "(-unit m)"));
  for (const double height : {0.0, 1.9, 2.5, 8.2, 40.0})
    EXPECT_EQ(unitWarning(upright(height), 1.0), "") << height;
  EXPECT_EQ(unitWarning(upright(2500), 0.001), "");
}

TEST(ScanWarnings, AUnitThatNobodyToldIsTakenWhereMetresCannotBe)
{
  EXPECT_EQ(metresPerUnit(2500), 0.001);
  EXPECT_EQ(metresPerUnit(250), 0.01);
  EXPECT_EQ(metresPerUnit(98), 0.0254);
  for (const double height : {0.0, 0.25, 2.5, 8.2, 40.0})
    EXPECT_EQ(metresPerUnit(height), 1.0) << height;
  EXPECT_TRUE(holds(unitNote(2500, 0.001), "millimetres"));
  EXPECT_TRUE(holds(unitNote(2500, 0.001), "2500 m high"));
  EXPECT_EQ(unitNote(2.5, 1.0), "");
}

TEST(ScanWarnings, FeetShowInFurnishedRooms)
{
  auto hall = upright(8.2);
  EXPECT_EQ(unitWarning(hall, 1.0), "");
  hall.is_furnished = true; // with objects of two metres
  EXPECT_TRUE(holds(unitWarning(hall, 1.0), "(-unit ft)"));
  EXPECT_EQ(unitWarning(hall, 0.3048), "");
  hall.room_height = 5.6;
  EXPECT_EQ(unitWarning(hall, 1.0), "");
}

TEST(ScanWarnings, AScaleThatIsNoUnit)
{
  EXPECT_TRUE(holds(unitWarning(upright(1.25), 1.0), "scale"));
  EXPECT_TRUE(holds(unitWarning(upright(0.25), 1.0), "0.3 m high"));
  auto decimetres = upright(26.0);
  EXPECT_EQ(unitWarning(decimetres, 1.0), ""); // a hall
  decimetres.is_furnished = true;              // with objects of eight metres
  EXPECT_TRUE(holds(unitWarning(decimetres, 1.0), "scale"));
  auto parts = upright(1.25); // such as gaps below tables
  parts.has_rooms = false;
  EXPECT_EQ(unitWarning(parts, 1.0), "");
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

TEST(ScanWarnings, PassagesWithSillsHangFromCeilings)
{
  const auto passages = [](const std::vector<double>& rises) {
    std::vector<RoomOpening> openings(rises.size());
    for (std::size_t i = 0; i < rises.size(); ++i)
      openings[i].rise = rises[i];
    return openings;
  };
  const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  const auto line = endWarning(passages({0.25, 0.0, 0.3}), up);
  EXPECT_TRUE(holds(line, "2 of 2 passages"));
  EXPECT_TRUE(holds(line, "set -up -z"));
  EXPECT_EQ(endWarning(passages({0.25}), up), ""); // one may be a serving hatch
  EXPECT_EQ(endWarning(passages({0.25, 0.3, -0.25}), up), "");
  EXPECT_EQ(endWarning(passages({0.05, 0.05, 0.05}), up), ""); // as high as the room
  EXPECT_EQ(endWarning({}, up), "");
  EXPECT_EQ(endOfPassages(passages({0.25, 0.0, 0.3})), 1);
  EXPECT_EQ(endOfPassages(passages({-0.25, 0.0, -0.3})), -1);
  EXPECT_EQ(endOfPassages(passages({-0.25, 0.0, 0.3})), 0);
  EXPECT_TRUE(allPassagesStand(passages({-0.25, 0.0, -0.3})));
  EXPECT_FALSE(allPassagesStand(passages({-0.25, 0.0})));
  EXPECT_FALSE(allPassagesStand(passages({-0.25, -0.3, -0.3, -0.3, 0.3})));
  const auto turned = reversedNote(passages({0.25, 0.0, 0.3}), Vertical());
  EXPECT_TRUE(holds(turned, "upside down: taken as upright along -z (-up -z)."));
  EXPECT_TRUE(holds(turned, "Taken along z, 2 of 2 passages"));
  EXPECT_EQ(reversedNote(passages({0.25, 0.3}), along({0.0f, 0.0f, -1.0f})), "");
  auto unclear = along({1.0f, 0.0f, 0.0f});
  unclear.is_end_known = false;
  const auto lying = reversedNote(passages({0.25, 0.0, 0.3}), unclear);
  EXPECT_TRUE(holds(lying, "upright along -x (-up -x). Taken along x, 2 of 2"));
}

TEST(ScanWarnings, HowAScanWasStoodUpright)
{
  EXPECT_EQ(verticalNote(Vertical()), "");
  EXPECT_EQ(verticalNote(along({0.01f, 0.0f, 1.0f})), ""); // 0.6 degrees
  const auto tilted = verticalNote(along({0.0f, 0.342f, 0.94f}));
  EXPECT_TRUE(holds(tilted, "tilted by 20 degrees"));
  EXPECT_TRUE(holds(tilted, "(-up 0,0.342,0.94)"));
  const auto lying = verticalNote(along({0.0f, 1.0f, 0.01f}));
  EXPECT_TRUE(holds(lying, "lies on its side"));
  EXPECT_TRUE(holds(lying, "(-up y)"));
  EXPECT_TRUE(holds(verticalNote(along({0.0f, 0.0f, -1.0f})), "upside down"));
  auto unclear = along({1.0f, 0.0f, 0.0f});
  unclear.is_end_known = false;
  EXPECT_TRUE(holds(verticalNote(unclear), "set -up -x"));
  unclear = along({0.0f, 0.0f, 1.0f});
  unclear.is_end_known = false;
  EXPECT_TRUE(holds(verticalNote(unclear), "may be upside down"));
  Vertical doubtful;
  doubtful.doubtful = Eigen::Vector3f::UnitY();
  EXPECT_TRUE(holds(verticalNote(doubtful), "may lie on its side"));
  EXPECT_TRUE(holds(verticalNote(doubtful), "(-up y or -up -y)"));
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
