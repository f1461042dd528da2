/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/placed_points.h"

#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/conversions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace pcl::indoor::tool;

namespace {

using Cloud = pcl::PointCloud<pcl::PointNormal>;

/** The walls of a box far from 0 0 0, with their normals. */
Cloud
walls(std::size_t count)
{
  std::mt19937 rng(3);
  std::uniform_real_distribution<float> place(1.0f, 5.0f);
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    pcl::PointNormal point;
    point.getVector3fMap() << place(rng), place(rng), place(rng);
    const auto axis = static_cast<int>(i % 3);
    point.data[axis] = 1.0f;
    point.getNormalVector3fMap() = Eigen::Vector3f::Unit(axis);
    cloud.push_back(point);
  }
  return cloud;
}

CloudFile
fileOf(const Cloud& cloud)
{
  pcl::PCLPointCloud2 data;
  pcl::toPCLPointCloud2(cloud, data);
  return withPoints("scan", data, {});
}

void
add(Cloud& cloud, std::size_t count, const Eigen::Vector3f& place)
{
  pcl::PointNormal point;
  point.getVector3fMap() = place;
  point.getNormalVector3fMap() = Eigen::Vector3f::UnitX();
  for (std::size_t i = 0; i < count; ++i)
    cloud.push_back(point);
}

} // namespace

TEST(PlacedPoints, ThousandsAtOnePlaceAreNone)
{
  auto cloud = walls(20000);
  const Eigen::Vector3f scanner(2.5f, 2.5f, 2), other(-7, 0, 9.5f);
  add(cloud, 3000, scanner);
  add(cloud, 250, other);
  const auto file = fileOf(cloud);
  EXPECT_EQ(file.finite_count, 20000u);
  EXPECT_EQ(file.copy_count, 0u);
  ASSERT_EQ(file.left_out.size(), 2u);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    EXPECT_EQ(pcl::isFinite((*file.points)[i]), i < 20000);
  EXPECT_EQ(file.notes,
            (std::vector<std::string>{
                "3000 of 23250 points lie at 2.5 2.5 2, as if nothing had been "
                "measured: they are left out",
                "250 of 23250 points lie at -7 0 9.5, as if nothing had been "
                "measured: they are left out"}));
}

TEST(PlacedPoints, ManyPlacesTakeFewLines)
{
  auto cloud = walls(20000);
  for (int station = 0; station < 7; ++station)
    add(cloud, 300, Eigen::Vector3f(2, 0.5f * static_cast<float>(station), 2));
  const auto file = fileOf(cloud);
  EXPECT_EQ(file.finite_count, 20000u);
  EXPECT_EQ(file.left_out.size(), 7u);
  ASSERT_EQ(file.notes.size(), 3u);
  EXPECT_EQ(file.notes.back(),
            "1500 of 22100 points lie at 5 more places, as if nothing had been "
            "measured: they are left out");
}

TEST(PlacedPoints, MostOfThemMayBeNone)
{ // and the middle is that of the others
  auto cloud = walls(5000);
  for (auto& point : cloud)
    point.x += 40000.0f;
  add(cloud, 9000, Eigen::Vector3f::Zero());
  const auto file = fileOf(cloud);
  EXPECT_EQ(file.finite_count, 5000u);
  EXPECT_NEAR(file.offset.x(), 40002.0, 2.0);
}

TEST(PlacedPoints, TheCopiesOfAScanStay)
{
  for (const int copies : {2, 5}) {
    auto cloud = walls(5000);
    const auto once = cloud;
    for (int copy = 1; copy < copies; ++copy)
      cloud += once;
    const auto file = fileOf(cloud);
    EXPECT_EQ(file.finite_count, cloud.size());
    EXPECT_EQ(file.copy_count, cloud.size() - 5000);
    EXPECT_TRUE(file.left_out.empty());
    ASSERT_EQ(file.notes.size(), 1u);
    EXPECT_EQ(file.notes[0].find(std::to_string(cloud.size() - 5000) + " of " +
                                 std::to_string(cloud.size()) + " points lie exactly"),
              0u);
    add(cloud, 2000, Eigen::Vector3f::Zero());
    EXPECT_EQ(fileOf(cloud).finite_count, cloud.size() - 2000);
  }
}

TEST(PlacedPoints, RoundedOnesStay)
{
  auto cloud = walls(50000);
  for (auto& point : cloud)
    point.getVector3fMap() = 0.2f * (5.0f * point.getVector3fMap()).array().round();
  EXPECT_EQ(fileOf(cloud).finite_count, cloud.size());
}

TEST(PlacedPoints, ZeroIsNoneInRows)
{
  auto cloud = walls(300);
  add(cloud, 20, Eigen::Vector3f::Zero());
  EXPECT_EQ(fileOf(cloud).finite_count, 320u);
  cloud.width = 32;
  cloud.height = 10;
  const auto file = fileOf(cloud);
  EXPECT_EQ(file.finite_count, 300u);
  EXPECT_EQ(file.points->height, 10u);
  EXPECT_EQ(file.notes.size(), 1u);
}

TEST(PlacedPoints, NormalsThatAreNoneAreNotUsed)
{
  const auto cloud = walls(6000);
  EXPECT_TRUE(fileOf(cloud).has_normals);
  EXPECT_TRUE(fileOf(cloud).notes.empty());
  auto zeros = cloud, up = cloud;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    up[i].getNormalVector3fMap() = Eigen::Vector3f::UnitZ();
    if (i % 2 == 0)
      zeros[i].getNormalVector3fMap().setZero();
  }
  const auto file = fileOf(zeros);
  EXPECT_FALSE(file.has_normals);
  EXPECT_EQ(file.notes,
            std::vector<std::string>{"the normals are not used, they are estimated: "
                                     "3000 of 6000 have length 1"});
  EXPECT_FALSE(fileOf(up).has_normals);
}
