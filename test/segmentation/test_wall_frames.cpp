/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "wall_frames.h"

#include <gtest/gtest.h>

using namespace pcl::indoor;

namespace {

constexpr double voxel_size = 0.03;
const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();

/** The plane with this normal at a height of 2 m along it. */
StructurePlane
planeAlong(const Eigen::Vector3d& normal)
{
  StructurePlane plane;
  plane.normal = normal;
  plane.offset = 2;
  return plane;
}

const StructurePlane wall = planeAlong(Eigen::Vector3d::UnitX());

/** Points along x from one depth to another, behind the wall (< 0) or before it, the
 * first of them in depths of their own. */
std::vector<Eigen::Vector3f>
bar(double from, double to, const std::vector<double>& first = {})
{
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 100; ++i) {
    const double depth = i < static_cast<int>(first.size())
                             ? first[i]
                             : from + (to - from) * i / 99;
    points.emplace_back(static_cast<float>(wall.offset + depth), 0.0f, 0.01f * i);
  }
  return points;
}

bool
isLeftOut(const std::vector<Eigen::Vector3f>& points,
          const std::vector<StructurePlane>& planes = {wall},
          const Eigen::Vector3f& upwards = up)
{
  std::vector<std::uint8_t> left_out(points.size(), 0);
  leaveOutWallFrames(points,
                     planes,
                     upwards,
                     voxel_size,
                     std::vector<std::uint32_t>(points.size(), 3),
                     left_out);
  for (const auto flag : left_out)
    EXPECT_EQ(flag, left_out.front());
  return left_out.front() != 0;
}

TEST(WallFrames, GoThroughTheWall)
{
  EXPECT_TRUE(isLeftOut(bar(-0.15, 0.1)));
  EXPECT_TRUE(isLeftOut(bar(-0.19, -0.04))) << "in a deep reveal";
  EXPECT_FALSE(isLeftOut(bar(0, 0.19))) << "a wall cabinet";
  EXPECT_FALSE(isLeftOut(bar(-0.025, 0.19))) << "noise of less than a voxel";
}

TEST(WallFrames, AreThin)
{
  EXPECT_FALSE(isLeftOut(bar(-0.1, 0.25)));
  EXPECT_FALSE(isLeftOut(bar(-0.25, 0.1)));
}

TEST(WallFrames, MayHaveFewPointsElsewhere)
{
  EXPECT_TRUE(isLeftOut(bar(-0.1, 0.1, std::vector<double>(5, 0.5))));
  EXPECT_FALSE(isLeftOut(bar(-0.1, 0.1, std::vector<double>(6, 0.5))));
  EXPECT_TRUE(isLeftOut(bar(0, 0.1, std::vector<double>(5, -0.04))));
  EXPECT_FALSE(isLeftOut(bar(0, 0.1, std::vector<double>(4, -0.04))));
}

TEST(WallFrames, AreInAnyWallButNotInTheFloor)
{
  const auto other = planeAlong(Eigen::Vector3d::UnitY());
  EXPECT_TRUE(isLeftOut(bar(-0.15, 0.1), {other, wall}));
  EXPECT_FALSE(isLeftOut(bar(-0.15, 0.1), {other}));
  EXPECT_FALSE(isLeftOut(bar(-0.15, 0.1), {wall}, Eigen::Vector3f::UnitX()));
  EXPECT_FALSE(isLeftOut(bar(-0.15, 0.1), {}));
}

TEST(WallFrames, LeaveOthersAndFlagsAlone)
{
  auto points = bar(-0.1, 0.1);
  std::vector<std::uint32_t> segments(100, 0);
  std::vector<std::uint8_t> left_out(100, 0);
  for (int i = 0; i < 100; ++i) {
    segments[i] = i % 2; // 1 stands before the wall
    if (segments[i] == 1)
      points[i].x() = 2.5f;
  }
  left_out[1] = 1;
  leaveOutWallFrames(points, {wall}, up, voxel_size, segments, left_out);
  for (int i = 0; i < 100; ++i)
    EXPECT_EQ(left_out[i], i % 2 == 0 || i == 1) << i;
  std::vector<std::uint8_t> none;
  leaveOutWallFrames({}, {wall}, up, voxel_size, {}, none);
  EXPECT_TRUE(none.empty());
}

} // namespace
