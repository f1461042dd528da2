/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/floor_side.h"
#include "support/synthetic_scenes.h"

#include <pcl/segmentation/scan_overview.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

using Points = std::vector<Eigen::Vector3f>;

constexpr double degree = M_PI / 180.0;

/** Two storeys of 2.5 m, each with four rooms of 4 x 5 m; on the floor of each stand
 * two boxes of 2 x 0.8 x 0.7 m, or none. */
Points
houseOfRooms(bool is_furnished = true)
{
  std::vector<RoomBox> boxes;
  Points furniture;
  std::vector<Eigen::AlignedBox3f> below; // where it hides the floor
  for (int storey = 0; storey < 2; ++storey)
    for (int x = 0; x < 2; ++x)
      for (int y = 0; y < 2; ++y) {
        const Eigen::Vector3f low(4.2f * x, 5.2f * y, 2.8f * storey);
        boxes.push_back({low, low + Eigen::Vector3f(4, 5, 2.5f), 1});
        for (const float at : {0.8f, 3.2f}) {
          const Eigen::Vector3f corner = low + Eigen::Vector3f(1, at, -0.05f);
          below.emplace_back(corner, corner + Eigen::Vector3f(2, 0.8f, 0.1f));
          for (float u = 0.0f; u < 2.0f; u += 0.05f)
            for (float v = 0.0f; v < 0.8f; v += 0.05f)
              furniture.push_back(corner + Eigen::Vector3f(u, v, 0.75f));
        }
      }
  auto points = rooms(boxes, {}, 0.05f).points;
  if (!is_furnished)
    return points;
  const auto is_hidden = [&](const Eigen::Vector3f& point) {
    return std::any_of(below.begin(), below.end(), [&](const auto& box) {
      return box.contains(point);
    });
  };
  points.erase(std::remove_if(points.begin(), points.end(), is_hidden), points.end());
  points.insert(points.end(), furniture.begin(), furniture.end());
  return points;
}

Points
turned(const Points& points, const Eigen::Matrix3d& turn)
{
  Points result;
  for (const auto& point : points)
    result.push_back((turn * point.cast<double>()).cast<float>());
  return result;
}

Eigen::Matrix3d
turnAbout(const Eigen::Vector3d& axis, double degrees)
{
  return Eigen::AngleAxisd(degrees * degree, axis.normalized()).toRotationMatrix();
}

/** Between two directions, degrees. */
double
angleBetween(const Eigen::Vector3f& a, const Eigen::Vector3d& b)
{
  return std::acos(std::clamp(a.cast<double>().dot(b), -1.0, 1.0)) / degree;
}

} // namespace

TEST(Vertical, ALevelScanIsTakenAsItIs)
{
  const auto points = houseOfRooms();
  for (const double tilt : {0.0, 0.4, 0.8}) {
    const auto vertical =
        findVertical(turned(points, turnAbout(Eigen::Vector3d(1, 2, 0), tilt)));
    EXPECT_TRUE(vertical.is_found);
    EXPECT_NEAR(vertical.tilt() / degree, tilt, 0.3); // a sample's planes of 0.3 m
    EXPECT_EQ(vertical.upAxis(), Eigen::Vector3f::UnitZ());
    EXPECT_NEAR(vertical.room_height, 2.5, 0.15); // along z
  }
}

TEST(Vertical, FollowsATilt)
{
  const auto points = houseOfRooms();
  for (const double tilt : {2.0, 5.0, 11.0, 20.0, 30.0, 44.0})
    for (const double azimuth : {0.0, 33.0, 90.0}) {
      const auto turn = turnAbout(turnAbout(Eigen::Vector3d::UnitZ(), azimuth) *
                                      Eigen::Vector3d::UnitX(),
                                  tilt);
      const auto vertical = findVertical(turned(points, turn));
      EXPECT_TRUE(vertical.is_found);
      EXPECT_TRUE(vertical.is_end_known);
      EXPECT_LT(angleBetween(vertical.upAxis(), turn.col(2)), 0.4) << tilt;
      EXPECT_NEAR(vertical.room_height, 2.5, 0.15);
    }
}

TEST(Vertical, FurnitureTellsFloorsFromCeilings)
{
  const auto points = houseOfRooms();
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {1.0f, -1.0f}) {
      const Eigen::Vector3f up = sign * Eigen::Vector3f::Unit(axis);
      const auto turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(),
                                                           up.cast<double>())
                            .toRotationMatrix();
      const auto vertical = findVertical(turned(points, turn));
      EXPECT_TRUE(vertical.is_end_known);
      EXPECT_EQ(vertical.upAxis(), up); // exactly
    }
}

TEST(Vertical, ObjectsAtTheCeilingsOfLowRoomsRaiseADoubt)
{
  for (const double turn : {0.0, 180.0}) {
    auto points = turned(houseOfRooms(), turnAbout(Eigen::Vector3d::UnitX(), turn));
    for (auto& point : points)
      point *= 0.6f; // 1.5 m: no rooms in any unit, as in scans that show little
    const auto vertical = findVertical(points);
    EXPECT_EQ(vertical.upAxis(), Eigen::Vector3f::UnitZ()) << turn;
    EXPECT_EQ(vertical.is_end_known, turn == 0.0) << turn;
  }
}

TEST(Vertical, MoreObjectsAtACeilingAreNoProof)
{
  EXPECT_EQ((ObjectsAtEnds{110, 210, 1800}.clearEnd()),
            1); // a real map that is upright
  EXPECT_EQ((ObjectsAtEnds{110, 210, 1800}.clearEnd(3.0)), 0);
  EXPECT_EQ((ObjectsAtEnds{60, 210, 1800}.clearEnd(3.0)), 1);
  EXPECT_EQ((ObjectsAtEnds{60, 210, 9000}.clearEnd(3.0)), 0); // hardly furnished
  EXPECT_EQ((ObjectsAtEnds{210, 60, 1800}.clearEnd()), -1);
}

TEST(Vertical, WithoutFurnitureTheEndNearerToZIsUp)
{
  const auto points = houseOfRooms(false);
  const auto down = turned(points, turnAbout(Eigen::Vector3d::UnitX(), 180.0));
  EXPECT_EQ(findVertical(down).upAxis(), Eigen::Vector3f::UnitZ());
  const auto lying =
      findVertical(turned(points, turnAbout(Eigen::Vector3d::UnitX(), 90.0)));
  EXPECT_FALSE(lying.is_end_known);
  EXPECT_EQ(lying.upAxis(), Eigen::Vector3f::UnitY());
}

TEST(Vertical, HeightsThatStandForNothingDoNoHarm)
{
  auto points = houseOfRooms();
  const auto height = findVertical(points).room_height;
  const auto count = points.size();
  for (std::size_t i = 0; i < count; i += 7)
    points.emplace_back(points[i].x(), points[i].y(), -10000.0f);
  EXPECT_NEAR(findVertical(points).room_height, height, 0.05);
}

TEST(Vertical, FollowsTheUnit)
{
  const auto points = houseOfRooms();
  for (const double unit : {0.001, 0.01, 0.0254, 0.3048, 1.0}) {
    Points scaled;
    for (const auto& point : points)
      scaled.push_back(point / static_cast<float>(unit));
    const auto vertical = findVertical(scaled);
    EXPECT_NEAR(vertical.room_height * unit, 2.5, 0.1); // another sample
    EXPECT_EQ(vertical.upAxis(), Eigen::Vector3f::UnitZ());
    EXPECT_EQ(likelyMetresPerUnit(vertical.room_height), unit);
  }
}

TEST(Vertical, RoomsNarrowerThanHighStayUpright)
{
  std::vector<RoomBox> boxes;
  for (int i = 0; i < 5; ++i) {
    const Eigen::Vector3f low(0, 2.6f * i, 0);
    boxes.push_back({low, low + Eigen::Vector3f(8, 2.4f, 3.4f), 1});
  }
  auto points = rooms(boxes, {}, 0.05f).points;
  // A carried scanner drifts: floors and ceilings are seen at several heights.
  for (auto& point : points)
    point.z() +=
        0.12f *
        ((5 * static_cast<int>(point.x()) + 3 * static_cast<int>(point.y() + 1.0f)) %
         8);
  const auto vertical = findVertical(points);
  EXPECT_TRUE(vertical.is_found);
  EXPECT_EQ(vertical.upAxis(), Eigen::Vector3f::UnitZ());
}

TEST(Vertical, DependsNeitherOnTheOrderNorOnFarPoints)
{
  auto points = turned(houseOfRooms(), turnAbout(Eigen::Vector3d(1, 1, 0), 17.0));
  const auto vertical = findVertical(points);
  std::mt19937 rng(3);
  for (std::size_t i = points.size(); i > 1; --i)
    std::swap(points[i - 1], points[rng() % i]);
  EXPECT_EQ(findVertical(points).direction, vertical.direction);
  for (int i = 0; i < 10; ++i)
    points.emplace_back(1e9f, -1e9f, 1e9f);
  EXPECT_EQ(findVertical(points).direction, vertical.direction);
}

TEST(Vertical, AnAxisThatIsSetHolds)
{
  const auto vertical = verticalAlong(Eigen::Vector3f(0, 3, 0), houseOfRooms());
  EXPECT_EQ(vertical.direction, Eigen::Vector3f::UnitY());
  EXPECT_NEAR(vertical.room_height, 5.0, 0.2);
}

TEST(Vertical, WithoutEvidenceTheScanIsTakenAsItIs)
{
  for (const std::size_t count : {0, 1, 999, 2000}) { // the last: all in one place
    const auto vertical = findVertical(Points(count, Eigen::Vector3f(1, 2, 3)));
    EXPECT_FALSE(vertical.is_found);
    EXPECT_EQ(vertical.upAxis(), Eigen::Vector3f::UnitZ());
    EXPECT_EQ(vertical.room_height, 0.0);
  }
  std::mt19937 rng(1);
  const auto random = [&rng] {
    return static_cast<float>(rng() % 20001) / 1e4f - 1.0f;
  };
  Points ball, plane, tunnel;
  for (int i = 0; i < 30000; ++i) {
    const Eigen::Vector3f p(random(), random(), random());
    ball.push_back(3.0f * p.normalized());
    plane.emplace_back(10.0f * p.x(), 0.9f * 10.0f * p.y(), 0.4f * 10.0f * p.y());
    const Eigen::Vector2f ring = 3.0f * p.tail<2>().normalized();
    tunnel.emplace_back(40.0f * p.x(), ring.x(), ring.y());
  }
  for (const auto& points : {ball, plane, tunnel}) {
    EXPECT_FALSE(findVertical(points).is_found);
    EXPECT_EQ(findVertical(points).upAxis(), Eigen::Vector3f::UnitZ());
  }
}
