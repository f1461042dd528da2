/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/indoor/distinct_points.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

using namespace pcl::indoor;

namespace {

std::vector<Eigen::Vector3f>
randomPoints(std::size_t count, unsigned values, std::uint32_t seed)
{
  std::mt19937 rng(seed);
  const auto value = [&] { return static_cast<float>(rng() % values) - 2.0f; };
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = value(), y = value(), z = value();
    points.emplace_back(x, y, z);
  }
  return points;
}

} // namespace

TEST(DistinctPoints, AreTheFirstOfEachPlace)
{
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const auto points = randomPoints(seed * 20, 1 + seed % 8, seed);
    std::map<std::tuple<float, float, float>, std::uint32_t> places;
    std::vector<std::uint32_t> first;
    const auto distinct = distinctPoints(points);
    ASSERT_EQ(distinct.place.size(), points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const auto key = std::make_tuple(points[i].x(), points[i].y(), points[i].z());
      const auto place = static_cast<std::uint32_t>(places.size());
      if (places.emplace(key, place).second)
        first.push_back(i);
      EXPECT_EQ(distinct.place[i], places.at(key));
    }
    EXPECT_EQ(distinct.first, first);
    EXPECT_EQ(distinct.copies(), points.size() - first.size());
    EXPECT_EQ(distinct.forAll(distinct.once(points)), points);
  }
}

TEST(DistinctPoints, ZeroIsMinusZero)
{
  EXPECT_EQ(distinctPoints({{0, 1, -0.0f}, {-0.0f, 1, 0}}).copies(), 1u);
}

TEST(DistinctPoints, TheLeastValueOfAPlaceIsFinite)
{
  const auto distinct = distinctPoints({{1, 1, 1}, {2, 2, 2}, {1, 1, 1}, {1, 1, 1}});
  const Eigen::Vector3f up(0, 0, 1), down(0, 0, -1), none(NAN, 0, 0);
  EXPECT_EQ(distinct.least({none, up, up, down}),
            (std::vector<Eigen::Vector3f>{down, up}));
  EXPECT_EQ(distinct.least({down, up, none, up}),
            (std::vector<Eigen::Vector3f>{down, up}));
  EXPECT_TRUE(distinct.least({}).empty());
}

namespace {

/** Points of a room that was scanned, all different. */
std::vector<Eigen::Vector3f>
differentPoints(std::size_t count)
{
  std::mt19937 rng(7);
  std::uniform_real_distribution<float> place(-20.0f, 20.0f);
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = place(rng), y = place(rng), z = place(rng);
    points.emplace_back(x, y, z);
  }
  return points;
}

} // namespace

TEST(DistinctPoints, AQuickLookTellsScansWithoutCopies)
{
  for (const std::size_t count : {50000, 300000, 2000000})
    EXPECT_FALSE(mayHaveCopies(differentPoints(count))) << count;
}

TEST(DistinctPoints, AQuickLookMissesNeitherCopiesNorCrowds)
{
  for (const std::size_t count : {300u, 50000u, 300000u}) {
    auto copies = differentPoints(count);
    copies.insert(copies.end(), copies.begin(), copies.begin() + count / 50);
    EXPECT_TRUE(mayHaveCopies(copies)) << count;
    EXPECT_TRUE(placesOfCopies(copies)) << count;
    auto crowd = differentPoints(count);
    crowd.insert(crowd.end(), 100, {1.0f, 2.0f, 3.0f});
    EXPECT_TRUE(mayHaveCopies(crowd)) << count;
  }
  EXPECT_FALSE(placesOfCopies(differentPoints(300)));
}
