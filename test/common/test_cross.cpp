/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "internal/cross.h"

#include <gtest/gtest.h>

namespace pcl::indoor {
namespace {

TEST(Cross, IsTheSignedAreaBetweenTwoVectors)
{
  const Eigen::Vector2d x(2, 0), y(0, 3), slanted(5, 3);
  EXPECT_EQ(crossOf(x, y), 6);
  EXPECT_EQ(crossOf(y, x), -6);
  EXPECT_EQ(crossOf(x, slanted), 6);
  EXPECT_EQ(crossOf(slanted, slanted), 0);
}

} // namespace
} // namespace pcl::indoor
