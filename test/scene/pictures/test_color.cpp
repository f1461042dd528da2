/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace pcl::indoor::tool;

namespace {

int
distance(Color a, Color b)
{
  return std::abs(a.red - b.red) + std::abs(a.green - b.green) +
         std::abs(a.blue - b.blue);
}

} // namespace

TEST(Color, NearLabelsHaveDistinctColours)
{
  for (std::uint32_t a = 0; a < 200; ++a)
    for (std::uint32_t b = a + 1; b < a + 8; ++b)
      EXPECT_GT(distance(labelColor(a), labelColor(b)), 40) << a << " and " << b;
}

TEST(Color, HeatGrowsLighterAndIsBounded)
{
  const auto light = [](Color c) { return 2 * c.red + 3 * c.green + c.blue; };
  for (int i = 0; i < 50; ++i)
    EXPECT_LT(light(heatColor(i / 50.0)), light(heatColor((i + 1) / 50.0))) << i;
  EXPECT_EQ(distance(heatColor(-3.0), heatColor(0.0)), 0);
  EXPECT_EQ(distance(heatColor(7.0), heatColor(1.0)), 0);
  EXPECT_EQ(heatColor(std::numeric_limits<double>::quiet_NaN()).red, 128);
}
