/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/points_aside.h"

#include "support/folder_test.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>

using namespace pcl::indoor::tool;

class PointsAsideFiles : public pcl::indoor::test::FolderTest {};

namespace {

/** More than a block of the file, with values of all kinds. */
pcl::PointCloud<pcl::PointXYZ>
manyPoints()
{
  pcl::PointCloud<pcl::PointXYZ> points;
  for (int i = 0; i < 100000; ++i)
    points.points.emplace_back(0.1f * i, -1e-30f * i, i % 7 == 0 ? NAN : 1e9f - i);
  return points;
}

bool
areSame(const pcl::PointCloud<pcl::PointXYZ>& a,
        const pcl::PointCloud<pcl::PointXYZ>& b)
{
  return a.size() == b.size() && std::memcmp(a.points.data(),
                                             b.points.data(),
                                             a.size() * sizeof(pcl::PointXYZ)) == 0;
}

} // namespace

TEST_F(PointsAsideFiles, ComeBackBitByBit)
{
  const auto expected = manyPoints();
  auto points = expected;
  PointsAside aside(points, path("aside"));
  EXPECT_EQ(points.points.capacity(), 0u);
  EXPECT_FALSE(std::filesystem::exists(path("aside"))); // to others
  aside.bringBack();
  EXPECT_TRUE(areSame(points, expected));
  aside.bringBack(); // no more
  EXPECT_TRUE(areSame(points, expected));
}

TEST_F(PointsAsideFiles, StayWhereNoFileCanBeWritten)
{
  const auto expected = manyPoints();
  auto points = expected;
  PointsAside aside(points, "/no/such/folder/aside");
  EXPECT_TRUE(areSame(points, expected));
  aside.bringBack();
  EXPECT_TRUE(areSame(points, expected));
}

TEST_F(PointsAsideFiles, OfAnEmptyCloudAreNone)
{
  pcl::PointCloud<pcl::PointXYZ> points;
  PointsAside aside(points, path("aside"));
  aside.bringBack();
  EXPECT_TRUE(points.empty());
}
