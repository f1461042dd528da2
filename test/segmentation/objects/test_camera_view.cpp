/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/objects/camera_view.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace pcl::indoor;

namespace {

using Points = std::vector<Eigen::Vector3f>;

constexpr float degree = static_cast<float>(M_PI / 180);

/** A surface across the view of a camera at the origin, 50 degrees wide. */
Points
wallAt(float depth)
{
  Points points;
  for (int i = -20; i <= 20; ++i)
    for (int j = -15; j <= 15; ++j)
      points.emplace_back(depth * std::tan(static_cast<float>(i) * 1.25f * degree),
                          depth * std::tan(static_cast<float>(j) * 1.25f * degree),
                          depth);
  return points;
}

/** Normals of the floor, of a wall and of half as much of another across, in the frame
 * of a camera that looks down by a pitch and leans by a roll, in degrees. */
Points
normalsOfRoom(float pitch, float roll, float noise, Eigen::Vector3f& up)
{
  const Eigen::Matrix3f camera =
      (Eigen::AngleAxisf(roll * degree, Eigen::Vector3f::UnitZ()) *
       Eigen::AngleAxisf(pitch * degree, Eigen::Vector3f::UnitX()) *
       Eigen::AngleAxisf(0.6f, Eigen::Vector3f::UnitY()))
          .toRotationMatrix();
  up = camera * -Eigen::Vector3f::UnitY();
  std::mt19937 random(1);
  std::normal_distribution<float> error(0, noise);
  Points normals;
  for (int i = 0; i < 1000; ++i)
    for (const auto& [normal, step] : {std::make_pair(Eigen::Vector3f(0, -1, 0), 1),
                                       std::make_pair(Eigen::Vector3f(1, 0, 0), 1),
                                       std::make_pair(Eigen::Vector3f(0, 0, -1), 2)})
      if (i % step == 0) {
        const Eigen::Vector3f off(error(random), error(random), error(random));
        normals.push_back((camera * normal + off).normalized());
      }
  return normals;
}

} // namespace

TEST(CameraView, TheDistanceOfWhatIsLookedAtTellsRoomsFromTables)
{
  const Eigen::Vector3f camera = Eigen::Vector3f::Zero();
  EXPECT_EQ(captureOf(wallAt(1.3f), camera), Capture::TableView);
  EXPECT_EQ(captureOf(wallAt(1.5f), camera), Capture::RoomView);
  // A table's floor and a room's things beside the middle do not count.
  for (const auto& [middle, beside] :
       {std::make_pair(1.0f, 3.0f), std::make_pair(3.0f, 0.7f)}) {
    auto points = wallAt(beside);
    for (auto& point : points)
      if (point.head<2>().norm() < std::tan(11 * degree) * point.z())
        point *= middle / beside;
    EXPECT_EQ(captureOf(points, camera),
              middle > 2 ? Capture::RoomView : Capture::TableView);
  }
}

TEST(CameraView, ACameraMayStandAnywhere)
{
  auto points = wallAt(3);
  const Eigen::Vector3f place(10, -20, 30);
  for (auto& point : points)
    point += place;
  EXPECT_EQ(captureOf(points, place), Capture::RoomView);
  EXPECT_EQ(captureOf(points, place + Eigen::Vector3f(0, 0, 2)), Capture::TableView);
}

TEST(CameraView, WhatIsAllAroundIsNoView)
{
  const Eigen::Vector3f camera = Eigen::Vector3f::Zero();
  Points all_around;
  for (const auto& point : wallAt(2))
    for (const auto& turned : {point,
                               Eigen::Vector3f(-point.z(), point.y(), point.x()),
                               Eigen::Vector3f(point.z(), point.y(), -point.x()),
                               Eigen::Vector3f(-point)})
      all_around.push_back(turned);
  EXPECT_EQ(captureOf(all_around, camera), Capture::Scan);
  auto points = wallAt(3); // 1,271 of them
  points.insert(points.end(), 12, Eigen::Vector3f(0, 0, -1));
  EXPECT_EQ(captureOf(points, camera), Capture::RoomView) << "a few are errors";
  points.insert(points.end(), 2, Eigen::Vector3f(0, 0, -1));
  EXPECT_EQ(captureOf(points, camera), Capture::Scan);
  EXPECT_EQ(captureOf({}, camera), Capture::Scan);
}

TEST(CameraView, UpIsAcrossWallsAndAlongTheFloorsNormal)
{
  for (const float pitch : {-25.0f, 0.0f, 20.0f, 35.0f})
    for (const float roll : {-10.0f, 0.0f, 5.0f}) {
      Eigen::Vector3f up;
      const auto exact = upOfView(normalsOfRoom(pitch, roll, 0, up));
      EXPECT_NEAR((exact - up).norm(), 0, 1e-5) << pitch << ' ' << roll;
      const auto noisy = upOfView(normalsOfRoom(pitch, roll, 0.1f, up));
      EXPECT_NEAR((noisy - up).norm(), 0, 0.01) << pitch << ' ' << roll;
      EXPECT_NEAR(noisy.norm(), 1, 1e-5);
    }
}

TEST(CameraView, WallsAloneOrTheFloorAloneTellWhatIsUp)
{
  Eigen::Vector3f up;
  const auto all = normalsOfRoom(20, 0, 0, up);
  Points floor, walls;
  for (const auto& normal : all)
    (std::abs(normal.dot(up)) > 0.5f ? floor : walls).push_back(normal);
  EXPECT_NEAR((upOfView(floor) - up).norm(), 0, 1e-5);
  EXPECT_NEAR((upOfView(walls) - up).norm(), 0, 1e-5);
}

TEST(CameraView, WithoutNormalsUpIsAgainstY)
{
  const Eigen::Vector3f against_y(0, -1, 0);
  EXPECT_EQ(upOfView({}), against_y);
  EXPECT_EQ(upOfView(Points(10, Eigen::Vector3f::Zero())), against_y);
}
