/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/room_objects.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace pcl::indoor;

namespace {

/** Points within a box, its corners among them. */
std::vector<Eigen::Vector3d>
pointsWithin(const UprightBox& box, std::uint32_t seed)
{
  std::mt19937 random(seed);
  const auto share = [&random] { return random() / 4294967296.0 - 0.5; };
  std::vector<Eigen::Vector3d> points;
  const Eigen::AngleAxisd turn(box.yaw, Eigen::Vector3d::UnitZ());
  const auto add = [&](double x, double y, double z) {
    points.push_back(box.center +
                     turn * Eigen::Vector3d(x, y, z).cwiseProduct(box.size));
  };
  for (int corner = 0; corner < 8; ++corner)
    add(corner % 2 - 0.5, corner / 2 % 2 - 0.5, corner / 4 - 0.5);
  for (int i = 0; i < 50; ++i)
    add(share(), share(), share());
  return points;
}

} // namespace

TEST(UprightBox, IsTheBoxThatThePointsFill)
{
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    UprightBox box;
    box.center = {3.0 + seed, -2.0, 0.5};
    box.size = {1.8, 0.7, 0.9};
    box.yaw = std::fmod(0.37 * seed, M_PI);
    const auto found = uprightBox(pointsWithin(box, seed));
    EXPECT_TRUE(found.center.isApprox(box.center, 1e-9)) << seed;
    EXPECT_TRUE(found.size.isApprox(box.size, 1e-9)) << found.size.transpose();
    EXPECT_NEAR(std::sin(found.yaw - box.yaw), 0.0, 1e-9);
    EXPECT_GE(found.yaw, 0.0);
    EXPECT_LT(found.yaw, M_PI);
  }
}

TEST(UprightBox, IsNoLargerThanInAnyOtherDirection)
{
  std::mt19937 random(7);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 40; ++i)
    points.emplace_back(random() % 1000 * 0.01, random() % 300 * 0.01, 0.0);
  const auto box = uprightBox(points);
  for (double yaw = 0.0; yaw < M_PI; yaw += 0.01) {
    Eigen::AlignedBox2d other;
    for (const auto& point : points)
      other.extend(Eigen::Rotation2Dd(-yaw) * point.head<2>());
    EXPECT_LE(box.size.x() * box.size.y(), other.volume() + 1e-9);
  }
}

TEST(UprightBox, FewPointsAndLinesHaveBoxes)
{
  EXPECT_EQ(uprightBox({}).size, Eigen::Vector3d::Zero());
  const auto of_one = uprightBox({{1.0, 2.0, 3.0}});
  EXPECT_EQ(of_one.center, Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(of_one.size, Eigen::Vector3d::Zero());
  const auto of_line = uprightBox({{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, {3.0, 3.0, 0.0}});
  EXPECT_NEAR(of_line.size.x(), 3.0 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(of_line.size.y(), 0.0, 1e-12);
  EXPECT_NEAR(of_line.yaw, M_PI_4, 1e-12);
}

TEST(UprightBox, DistanceIsFromItsSides)
{
  UprightBox box;
  box.size = {2.0, 1.0, 1.0};
  box.yaw = M_PI_2; // its length along y
  EXPECT_EQ(distanceTo(box, {0.2, 0.9, 0.0}), 0.0);
  EXPECT_NEAR(distanceTo(box, {2.5, 0.9, 0.0}), 2.0, 1e-12);
  EXPECT_NEAR(distanceTo(box, {0.5 + 3.0, 1.0 + 4.0, 0.0}), 5.0, 1e-12);
}
