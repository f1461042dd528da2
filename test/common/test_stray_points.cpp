/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/indoor/stray_points.h>

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <random>
#include <vector>

using pcl::indoor::putBack;
using pcl::indoor::strayPoints;
using pcl::indoor::takeOut;

namespace {

using Points = std::vector<Eigen::Vector3f>;
using Places = std::vector<std::size_t>;

/** Points in a cube of this edge whose lower corner is there. */
Points
cube(float edge, const Eigen::Vector3f& corner, std::size_t count)
{
  std::mt19937 rng(4);
  const auto random = [&] { return edge * static_cast<float>(rng() % 1001) / 1000; };
  Points points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(corner + Eigen::Vector3f(random(), random(), random()));
  return points;
}

} // namespace

TEST(StrayPoints, AreTheZerosOfAScanInUtmCoordinates)
{
  auto points = cube(8, {691000, 5336000, 520}, 100);
  EXPECT_EQ(strayPoints(points), Places{});
  points[17].setZero();
  points[18] = {691000, 5336000, std::numeric_limits<float>::max()};
  points[60].setZero();
  EXPECT_EQ(strayPoints(points), (Places{17, 18, 60}));
}

TEST(StrayPoints, AreNotThoseOfALargeScanNorOfOneInMillimetres)
{
  EXPECT_EQ(strayPoints(cube(2e4f, {0, 0, 0}, 100)), Places{});
  auto room = cube(9e3f, {0, 0, 0}, 100);
  room.emplace_back(-2e4f, 0.0f, 0.0f); // seen through a window, 20 m away
  EXPECT_EQ(strayPoints(room), Places{});
}

TEST(StrayPoints, NeedOthers)
{
  EXPECT_EQ(strayPoints({}), Places{});
  EXPECT_EQ(strayPoints({{1e9f, 0, 0}}), Places{});
  EXPECT_EQ(strayPoints({{1e7f, 0, 0}, {0, 1e7f, 0}, {0, 0, 1e7f}}), Places{});
}

TEST(StrayPoints, AreTakenOutAndPutBack)
{
  for (const std::size_t count : {0, 1, 2, 5})
    for (unsigned taken = 0; taken < 1u << count; ++taken) {
      std::vector<int> all(count), kept, expected;
      std::iota(all.begin(), all.end(), 1);
      Places places;
      for (std::size_t i = 0; i < count; ++i) {
        const bool is_taken = (taken >> i & 1) != 0;
        if (is_taken)
          places.push_back(i);
        else
          kept.push_back(all[i]);
        expected.push_back(is_taken ? 0 : all[i]);
      }
      auto values = all;
      takeOut(places, values);
      EXPECT_EQ(values, kept);
      putBack(places, 0, values);
      EXPECT_EQ(values, expected);
    }
  std::vector<int> nothing;
  takeOut({0, 3}, nothing); // there are no values of the points
  EXPECT_TRUE(nothing.empty());
}
