/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/features/station_orientation.h>

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using pcl::indoor::orientTowardsStations;

namespace {

/** Both faces of a wall at x = 0 and one point whose station is not known. */
class Wall : public testing::Test {
protected:
  pcl::PointCloud<pcl::PointXYZ> points_{4, 1, pcl::PointXYZ(0.0f, 1.0f, 1.0f)};
  pcl::PointCloud<pcl::Normal> normals_{4, 1, pcl::Normal(1.0f, 0.0f, 0.0f)};
  std::vector<Eigen::Vector3d> stations_{{3.0, 1.0, 1.5}, {-3.0, 1.0, 1.5}};
  std::vector<std::uint32_t> station_of_point_{1, 2, 0, 2};
};

} // namespace

TEST_F(Wall, NormalsAreTurnedToTheirOwnStation)
{
  EXPECT_EQ(orientTowardsStations(points_, stations_, station_of_point_, normals_), 2u);
  EXPECT_EQ(normals_[0].normal_x, 1.0f);
  EXPECT_EQ(normals_[1].normal_x, -1.0f);
  EXPECT_EQ(normals_[2].normal_x, 1.0f); // not known
  EXPECT_EQ(normals_[3].normal_x, -1.0f);
  EXPECT_EQ(orientTowardsStations(points_, stations_, station_of_point_, normals_), 0u);
}

TEST_F(Wall, NaNStaysNaN)
{
  normals_[1].normal_x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(orientTowardsStations(points_, stations_, station_of_point_, normals_), 1u);
  EXPECT_TRUE(std::isnan(normals_[1].normal_x));
}

TEST_F(Wall, WhatDoesNotFitIsRefused)
{
  const auto orient = [this] {
    return orientTowardsStations(points_, stations_, station_of_point_, normals_);
  };
  station_of_point_[0] = 3;
  EXPECT_THROW(orient(), pcl::BadArgumentException);
  station_of_point_.pop_back();
  EXPECT_THROW(orient(), pcl::BadArgumentException);
}

TEST(StationOrientation, OfNothingIsNothing)
{
  pcl::PointCloud<pcl::Normal> normals;
  EXPECT_EQ(orientTowardsStations({}, {}, {}, normals), 0u);
}
