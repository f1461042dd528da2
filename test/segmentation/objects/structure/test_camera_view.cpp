/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/structure/camera_view.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>

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

/** What a camera at the origin with 160 x 120 pixels sees of a wall. */
Points
pixelsOf(float depth)
{
  constexpr float focal_length = 131;
  Points points;
  for (int v = 0; v < 120; ++v)
    for (int u = 0; u < 160; ++u)
      points.emplace_back(depth * (static_cast<float>(u) - 79.5f) / focal_length,
                          depth * (static_cast<float>(v) - 59.5f) / focal_length,
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
  // A table's floor and a room's objects beside the middle do not count.
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

TEST(CameraView, NothingInTheMiddleIsNoTable)
{
  const Eigen::Vector3f camera = Eigen::Vector3f::Zero();
  auto points = wallAt(1);
  points.erase(std::remove_if(points.begin(),
                              points.end(),
                              [](const auto& point) {
                                return point.template head<2>().norm() <
                                       std::tan(11 * degree) * point.z();
                              }),
               points.end());
  EXPECT_TRUE(std::isnan(distanceInMiddle(points, camera)));
  EXPECT_EQ(captureOf(points, camera), Capture::RoomView);
  ObjectSegmentationInput input;
  input.points = points;
  input.viewpoint = {camera};
  input.capture = Capture::RoomView;
  EXPECT_EQ(farViewWarning(input), "");
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

TEST(CameraView, SmallObjectsAreATableUpToTwoMetres)
{
  const Eigen::Vector3f camera = Eigen::Vector3f::Zero();
  for (const auto& [depth, rough, capture] :
       {std::make_tuple(1.8f, true, Capture::TableView),
        std::make_tuple(1.8f, false, Capture::RoomView),
        std::make_tuple(2.1f, true, Capture::RoomView)}) {
    Points points; // balls of 5 cm side by side, or a wall
    for (const auto& point : pixelsOf(depth)) {
      const float x = std::remainder(point.x(), 0.1f),
                  y = std::remainder(point.y(), 0.1f);
      const float height =
          rough ? std::sqrt(std::max(0.0025f - x * x - y * y, 0.0f)) : 0;
      points.push_back(point * (1 - height / depth));
    }
    EXPECT_EQ(captureOf(points, camera), capture) << depth << ' ' << rough;
  }
}

TEST(CameraView, PixelsLieOnALatticeOfDirections)
{
  const Eigen::Vector3f camera(1, 2, 3);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> depth(0.5f, 3);
  auto points = pixelsOf(1);
  for (auto& point : points)
    point = camera + depth(random) * point;
  std::shuffle(points.begin(), points.end(), random);
  EXPECT_TRUE(arePixels(points, camera));
  auto some = points;
  some.resize(points.size() / 10);
  EXPECT_TRUE(arePixels(some, camera));
  for (auto& point : some) // as texts have it
    point = (point * 1000).array().round() / 1000;
  EXPECT_TRUE(arePixels(some, camera));
  EXPECT_FALSE(arePixels(points, camera + Eigen::Vector3f(0.5f, 0, 0)));
  some.resize(900);
  EXPECT_FALSE(arePixels(some, camera)) << "too few";
  for (auto& point : points)
    point += 0.05f * Eigen::Vector3f(depth(random), depth(random), depth(random));
  EXPECT_FALSE(arePixels(points, camera));
}

TEST(CameraView, ACameraMayLookAlongMinusZ)
{
  const Eigen::Vector3f camera(0, 0, 1);
  auto points = pixelsOf(1);
  for (auto& point : points)
    point = camera + halfTurned(point);
  for (const bool is_organized : {true, false}) {
    const auto view = cameraView(points, camera, is_organized);
    EXPECT_EQ(view.capture, Capture::TableView);
    EXPECT_TRUE(view.is_turned);
  }
  for (auto& point : points)
    point = halfTurned(point);
  const auto view = cameraView(points, halfTurned(camera), false);
  EXPECT_EQ(view.capture, Capture::TableView);
  EXPECT_FALSE(view.is_turned);
}

TEST(CameraView, PointsInFrontThatAreNoPixelsNeedRows)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> any(-0.5f, 0.5f);
  Points points;
  for (int i = 0; i < 5000; ++i)
    points.emplace_back(any(random), any(random), 2 + any(random));
  const Eigen::Vector3f camera = Eigen::Vector3f::Zero();
  EXPECT_NE(cameraView(points, camera, true).capture, Capture::Scan);
  EXPECT_EQ(cameraView(points, camera, false).capture, Capture::Scan);
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
