/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "objects/structure/wall_casings.h"

#include <gtest/gtest.h>

#include <cstddef>

using namespace pcl::indoor;

namespace {

constexpr double casing_voxel_size = 0.03;
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

const StructurePlane wall_plane = planeAlong(Eigen::Vector3d::UnitX());
constexpr std::size_t wall_points = 2;

/** Points along x from one depth to another, behind the wall (< 0) or before it, the
 * first of them in depths of their own. */
std::vector<Eigen::Vector3f>
bar(double from, double to, const std::vector<double>& first = {})
{
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 100; ++i) {
    const double depth =
        i < static_cast<int>(first.size()) ? first[i] : from + (to - from) * i / 99;
    points.emplace_back(static_cast<float>(wall_plane.offset + depth), 0.0f, 0.01f * i);
  }
  return points;
}

/** Flags of the points, after those of two that are in each plane, at the ends of a
 * diagonal of the wall. */
std::vector<std::uint8_t>
flagsOf(const std::vector<Eigen::Vector3f>& points,
        const std::vector<std::uint32_t>& segments,
        const std::vector<StructurePlane>& planes = {wall_plane},
        const Eigen::Vector3f& upwards = up)
{
  ObjectScene scene;
  scene.voxel_size = casing_voxel_size;
  scene.planes = planes;
  scene.up = upwards;
  std::vector<std::uint32_t> segment_of_point;
  for (std::uint32_t plane = 1; plane <= planes.size(); ++plane)
    for (const float side : {-1.0f, 1.0f}) {
      scene.points.emplace_back(2, side, 1 + side);
      segment_of_point.push_back(0);
      scene.plane_of_voxel.push_back(plane);
    }
  scene.points.insert(scene.points.end(), points.begin(), points.end());
  segment_of_point.insert(segment_of_point.end(), segments.begin(), segments.end());
  scene.plane_of_voxel.resize(scene.points.size(), 0);
  for (std::uint32_t i = 0; i < scene.points.size(); ++i)
    scene.voxels.cells.cell_of_point.push_back(i);
  const auto flags = flagStructureAndCasings(scene, segment_of_point);
  for (std::size_t i = 0; i < wall_points * planes.size(); ++i)
    EXPECT_EQ(flags[i], 1);
  const auto first = static_cast<std::ptrdiff_t>(wall_points * planes.size());
  return {flags.begin() + first, flags.end()};
}

bool
isFrame(const std::vector<Eigen::Vector3f>& points,
        const std::vector<StructurePlane>& planes = {wall_plane},
        const Eigen::Vector3f& upwards = up)
{
  const auto flags =
      flagsOf(points, std::vector<std::uint32_t>(points.size(), 3), planes, upwards);
  for (const auto flag : flags)
    EXPECT_EQ(flag, flags.front());
  return flags.front() != 0;
}

TEST(WallCasings, ReachBehindTheWall)
{
  EXPECT_TRUE(isFrame(bar(-0.15, 0.1)));
  EXPECT_TRUE(isFrame(bar(-0.19, -0.04))) << "in a deep reveal";
  EXPECT_FALSE(isFrame(bar(0, 0.19))) << "a wall_plane cabinet";
  EXPECT_FALSE(isFrame(bar(-0.025, 0.19))) << "noise of less than a voxel";
}

TEST(WallCasings, AreThin)
{
  EXPECT_FALSE(isFrame(bar(-0.1, 0.25)));
  EXPECT_FALSE(isFrame(bar(-0.25, 0.1)));
}

TEST(WallCasings, MayHaveFewPointsElsewhere)
{
  EXPECT_TRUE(isFrame(bar(-0.1, 0.1, std::vector<double>(5, 0.5))));
  EXPECT_FALSE(isFrame(bar(-0.1, 0.1, std::vector<double>(6, 0.5))));
  EXPECT_TRUE(isFrame(bar(0, 0.1, std::vector<double>(5, -0.04))));
  EXPECT_FALSE(isFrame(bar(0, 0.1, std::vector<double>(4, -0.04))));
}

TEST(WallCasings, AreInAnyWallButNotInTheFloor)
{
  const auto other = planeAlong(Eigen::Vector3d::UnitY());
  EXPECT_TRUE(isFrame(bar(-0.15, 0.1), {other, wall_plane}));
  EXPECT_FALSE(isFrame(bar(-0.15, 0.1), {other}));
  EXPECT_FALSE(isFrame(bar(-0.15, 0.1), {wall_plane}, Eigen::Vector3f::UnitX()));
  EXPECT_FALSE(isFrame(bar(-0.15, 0.1), {}));
}

TEST(WallCasings, AreNotBesideTheWall)
{
  auto points = bar(-0.15, 0.1);
  for (auto& point : points)
    point.y() = 1.19f;
  EXPECT_TRUE(isFrame(points));
  for (auto& point : points)
    point.y() = 1.21f;
  EXPECT_FALSE(isFrame(points)) << "in line with it";
}

TEST(WallCasings, AreFoundAmongOthers)
{
  auto points = bar(-0.1, 0.1);
  std::vector<std::uint32_t> segments;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    segments.push_back(i % 2);
    if (segments[i] == 1)
      points[i].x() = 2.5f; // before the wall
  }
  const auto flags = flagsOf(points, segments);
  for (std::size_t i = 0; i < flags.size(); ++i)
    EXPECT_EQ(flags[i], segments[i] == 0) << i;
  EXPECT_TRUE(flagsOf({}, {}).empty());
  EXPECT_TRUE(flagStructureAndCasings(ObjectScene(), {}).empty());
}

} // namespace
