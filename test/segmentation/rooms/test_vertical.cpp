/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/synthetic_scenes.h"

#include <pcl/segmentation/rooms/scan_signs.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

using Points = std::vector<Eigen::Vector3f>;

/** Two storeys of 2.5 m, each with four rooms of 4 x 5 m. */
Points
house()
{
  std::vector<RoomBox> boxes;
  for (int storey = 0; storey < 2; ++storey)
    for (int x = 0; x < 2; ++x)
      for (int y = 0; y < 2; ++y) {
        const Eigen::Vector3f low(4.2f * x, 5.2f * y, 2.8f * storey);
        boxes.push_back({low, low + Eigen::Vector3f(4, 5, 2.5f), 1});
      }
  return rooms(boxes, {}, 0.05f).points;
}

} // namespace

TEST(ScanSigns, FreeLengthsAreThoseOfTheRooms)
{
  const auto signs = scanSigns(house());
  // a column reaches from wall to wall of one of two rooms; noise of 5 mm on both sides
  EXPECT_NEAR(signs.free_length.x(), 4.0, 0.1);
  EXPECT_NEAR(signs.free_length.y(), 5.0, 0.1);
  EXPECT_NEAR(signs.free_length.z(), 2.5, 0.1);
  EXPECT_EQ(signs.uprightAxis(), 2);
}

TEST(ScanSigns, FollowAxesThatChangePlaces)
{
  const auto points = house();
  for (int axis = 0; axis < 3; ++axis) {
    Points turned;
    for (const auto& p : points)
      turned.emplace_back(p[(5 - axis) % 3], p[(6 - axis) % 3], p[(7 - axis) % 3]);
    const auto signs = scanSigns(turned);
    EXPECT_EQ(signs.uprightAxis(), axis);
    EXPECT_NEAR(signs.free_length[axis], 2.5, 0.1);
  }
}

TEST(ScanSigns, FollowTheUnit)
{
  const auto points = house();
  const double height = scanSigns(points).free_length.z();
  for (const double unit : {0.001, 0.01, 0.0254, 0.3048}) {
    Points scaled;
    for (const auto& p : points)
      scaled.push_back(p / static_cast<float>(unit));
    const auto signs = scanSigns(scaled);
    EXPECT_NEAR(signs.free_length.z() * unit, height, 0.05); // another sample
    EXPECT_EQ(signs.uprightAxis(), 2);
    EXPECT_EQ(likelyMetresPerUnit(signs.free_length.z()), unit);
  }
  EXPECT_EQ(likelyMetresPerUnit(height), 1.0);
}

TEST(ScanSigns, DependNeitherOnTheOrderNorOnFarPoints)
{
  auto points = house();
  const auto signs = scanSigns(points);
  std::mt19937 rng(3);
  for (std::size_t i = points.size(); i > 1; --i)
    std::swap(points[i - 1], points[rng() % i]);
  EXPECT_EQ(scanSigns(points).free_length, signs.free_length);
  EXPECT_EQ(scanSigns(points).uprightness, signs.uprightness);
  for (int i = 0; i < 10; ++i)
    points.emplace_back(1e9f, -1e9f, 1e9f);
  EXPECT_EQ(scanSigns(points).free_length, signs.free_length);
}

TEST(ScanSigns, TooFewPointsTellNothing)
{
  for (const std::size_t count : {0, 1, 999, 2000}) { // the last: all in one place
    const auto signs = scanSigns(Points(count, Eigen::Vector3f(1, 2, 3)));
    EXPECT_EQ(signs.free_length, Eigen::Vector3d::Zero());
    EXPECT_EQ(signs.uprightness, Eigen::Vector3d::Zero());
    EXPECT_EQ(signs.uprightAxis(), 2);
  }
}
