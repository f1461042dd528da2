/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/io/input_error.h>
#include <pcl/scene/scene_options.h>

#include <gtest/gtest.h>

using namespace pcl::indoor;

namespace {

Eigen::Vector3f
upAxisOf(const std::string& up)
{
  CoordinateOptions options;
  options.up = up;
  return options.upAxis();
}

} // namespace

TEST(CoordinateOptions, UpIsAnAxisOrThreeNumbers)
{
  EXPECT_EQ(upAxisOf("auto"), Eigen::Vector3f::UnitZ());
  EXPECT_EQ(upAxisOf("y"), Eigen::Vector3f::UnitY());
  EXPECT_EQ(upAxisOf("+x"), Eigen::Vector3f::UnitX());
  EXPECT_EQ(upAxisOf("-z"), Eigen::Vector3f(0, 0, -1));
  EXPECT_EQ(upAxisOf("1,-2,0.5"), Eigen::Vector3f(1, -2, 0.5f));
}

TEST(CoordinateOptions, AnythingElseIsRefused)
{
  for (const char* up : {"", "-", "zx", "1x", "ux", "w", "x-", "xy,", "0,0,0"})
    EXPECT_THROW(upAxisOf(up), InputError) << up;
}
