/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/indoor/point_resolution.h>

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace pcl::indoor;

TEST(RaisedToResolution, IsByTheSpacingOfARegularGrid)
{
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j)
      points.emplace_back(
          0.02f * static_cast<float>(i), 0.02f * static_cast<float>(j), 0);
  points.emplace_back(100.0f, 0.0f, 0.0f); // an outlier
  EXPECT_NEAR(raisedToResolution(points, 0.01), 0.05, 1e-5);
  EXPECT_NEAR(raisedToResolution(points, 0.003), 0.05, 1e-5);
  EXPECT_EQ(raisedToResolution(points, 0.06), 0.06);
  EXPECT_EQ(raisedToResolution({}, 0.06), 0.06);
  EXPECT_EQ(raisedToResolution({{1, 1, 1}}, 0.06), 0.06);
}

TEST(RaisedToResolution, CopiesOfAScanDoNotCount)
{
  std::mt19937 rng(5);
  std::uniform_real_distribution<float> place(0.0f, 4.0f), error(-1.0f, 1.0f);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 20000; ++i) // a wall and a floor, 4 cm from one another
    if (i % 2 == 0)
      points.emplace_back(place(rng), place(rng), 0);
    else
      points.emplace_back(0, place(rng), place(rng));
  const double once = raisedToResolution(points, 0.02);
  EXPECT_GT(once, 0.04);
  for (const float size : {0.0f, 0.0005f, 0.001f, 0.002f})
    for (const int copies : {1, 2, 4}) {
      auto all = points;
      for (int copy = 0; copy < copies; ++copy)
        for (const auto& point : points)
          all.push_back(point +
                        size * Eigen::Vector3f(error(rng), error(rng), error(rng)));
      EXPECT_NEAR(raisedToResolution(all, 0.02), once, 0.25 * once)
          << copies << " copies, " << size << " m";
    }
}
