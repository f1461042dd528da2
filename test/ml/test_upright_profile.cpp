/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/upright_profile.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace pcl::indoor {
namespace {

/** A round table: a level top of radius 0.5 at 0.75 m and an upright post below it. */
std::vector<OrientedPoint>
roundTable(std::size_t top_count, std::size_t post_count)
{
  std::vector<OrientedPoint> points;
  for (std::size_t k = 0; k < top_count; ++k) { // on the rim
    const float angle = 2 * static_cast<float>(M_PI) * static_cast<float>(k) /
                        static_cast<float>(top_count);
    points.push_back(
        {{0.5f * std::cos(angle) + 3, 0.5f * std::sin(angle) - 2, 0.75f}, {0, 0, 1}});
  }
  for (std::size_t k = 0; k < post_count; ++k)
    points.push_back(
        {{3, -2, 0.75f * static_cast<float>(k) / static_cast<float>(post_count)},
         {1, 0, 0}});
  return points;
}

float
sum(const std::vector<float>& values, std::size_t first, std::size_t count)
{
  return std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(first),
                         values.begin() + static_cast<std::ptrdiff_t>(first + count),
                         0.0f);
}

TEST(UprightProfile, EachPartIsAShareOfAllPoints)
{
  const auto values = uprightProfile(roundTable(60, 40), 0.0f);
  ASSERT_EQ(values.size(), upright_profile_size);
  EXPECT_NEAR(sum(values, 0, 18), 0.6f, 1e-5f);  // level, by height
  EXPECT_NEAR(sum(values, 18, 18), 0.4f, 1e-5f); // others
  EXPECT_NEAR(sum(values, 36, 8), 0.6f, 1e-5f);  // level, by layer
  EXPECT_NEAR(sum(values, 44, 8), 0.4f, 1e-5f);
  EXPECT_NEAR(sum(values, 52, 6), 0.6f, 1e-5f); // level, by ring
  EXPECT_NEAR(sum(values, 58, 6), 0.4f, 1e-5f);
  EXPECT_NEAR(sum(values, 64, 16), 1.0f, 1e-5f);
}

TEST(UprightProfile, ATableHasItsTopAtItsHeightAndItsPostAtTheAxis)
{
  const auto values = uprightProfile(roundTable(60, 40), 0.0f);
  EXPECT_NEAR(values[7], 0.6f, 1e-5f);      // 0.7 ... 0.8 m
  EXPECT_NEAR(values[36 + 7], 0.6f, 1e-5f); // the highest layer
  EXPECT_NEAR(values[52 + 5], 0.6f, 1e-5f); // the outer ring
  EXPECT_NEAR(values[58], 0.4f, 1e-5f);     // the innermost one
  EXPECT_NEAR(values[64 + 15], 0.6f, 1e-5f);
}

TEST(UprightProfile, OnlyHeightsDependOnTheFloor)
{
  const auto on_floor = uprightProfile(roundTable(60, 40), 0.0f);
  const auto raised = uprightProfile(roundTable(60, 40), 1.0f);
  EXPECT_NEAR(raised[13], 0.6f, 1e-5f); // 1.6 ... 1.8 m
  for (std::size_t k = 36; k < upright_profile_size; ++k)
    EXPECT_FLOAT_EQ(on_floor[k], raised[k]);
}

TEST(UprightProfile, TurningAboutTheVerticalChangesNothing)
{
  auto points = roundTable(61, 40);
  points.push_back({{3.1f, -1.7f, 0.4f}, {0, 1, 0}});
  const auto before = uprightProfile(points, 0.2f);
  for (auto& [position, normal] : points) {
    position = {-position.y(), position.x(), position.z()};
    normal = {-normal.y(), normal.x(), -normal.z()}; // signs of normals do not matter
  }
  const auto after = uprightProfile(points, 0.2f);
  for (std::size_t k = 0; k < upright_profile_size; ++k)
    EXPECT_NEAR(before[k], after[k], 1e-6f) << k;
}

TEST(UprightProfile, OnePointAndNone)
{
  EXPECT_EQ(sum(uprightProfile({}, 0.0f), 0, upright_profile_size), 0.0f);
  const auto values = uprightProfile({OrientedPoint{{1, 2, 3}, {0, 0, 1}}}, 0.0f);
  EXPECT_EQ(values[0], 1.0f);
  EXPECT_EQ(sum(values, 0, upright_profile_size), 4.0f);
}

} // namespace
} // namespace pcl::indoor
