/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "segmentation/objects/join/outline_of.h"

#include <gtest/gtest.h>

#include <random>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

Places
randomPlaces(std::mt19937& rng, std::size_t count)
{
  const auto random = [&] { return static_cast<float>(rng() % 2001) / 1000 - 1; };
  Places places;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = random(), y = random();
    places.emplace_back(x, 0.5f * y + 0.3f * x, random());
  }
  return places;
}

/** Share of random places of a square, four by four metres, that are in an outline. */
double
areaByChance(const KDop16& outline, std::mt19937& rng)
{
  const auto random = [&] {
    return 4 * (static_cast<double>(rng()) / 4294967296.0) - 2;
  };
  int within = 0;
  for (int i = 0; i < 20000; ++i) {
    const double x = random();
    within += isWithin(outline, x, random());
  }
  return 16 * within / 20000.0;
}

} // namespace

TEST(KDop16, DirectionsGoAround)
{
  EXPECT_EQ(outlineDirection(0), Eigen::Vector2d(1, 0));
  for (std::size_t d = 0; d < 16; ++d) {
    const auto here = outlineDirection(d), next = outlineDirection((d + 1) % 16);
    EXPECT_NEAR(here.norm(), 1, 1e-12);
    EXPECT_NEAR(here.dot(next), std::cos(M_PI / 8), 1e-12);
    EXPECT_GT(here.x() * next.y() - here.y() * next.x(), 0);
  }
}

TEST(KDop16, AreaIsThatOfThePolygon)
{
  EXPECT_NEAR(outlineArea(rectangle(-1, 2, 0.5f, 3)), 1.5, 1e-6);
  KDop16 around_circle;
  around_circle.fill(1);
  EXPECT_NEAR(outlineArea(around_circle), 16 * std::tan(M_PI / 16), 1e-6);
  EXPECT_EQ(outlineArea(rectangle(1, 1, 1, 2)), 0) << "a line";
  std::mt19937 rng(1);
  for (int trial = 0; trial < 20; ++trial) {
    const auto outline = outlineOf(randomPlaces(rng, 3 + trial));
    EXPECT_NEAR(outlineArea(outline), areaByChance(outline, rng), 0.1) << trial;
  }
}

TEST(KDop16, OutlinesAreJoinedAndCut)
{
  const auto a = rectangle(0, 0, 2, 1), b = rectangle(1, 0, 4, 1);
  EXPECT_EQ(hullOfBoth(a, b), rectangle(0, 0, 4, 1));
  EXPECT_NEAR(outlineArea(commonHull(a, b)), 1, 1e-6);
  EXPECT_EQ(outlineArea(commonHull(a, rectangle(3, 0, 4, 1))), 0);
}

TEST(KDop16, ALineCrossesItInASpan)
{
  const auto span = outlineSpan(rectangle(0, 1, 2, 3), 0.5);
  EXPECT_NEAR(span.low, 1, 1e-6);
  EXPECT_NEAR(span.high, 3, 1e-6);
  for (const double x : {-0.1, 2.1}) {
    const auto none = outlineSpan(rectangle(0, 1, 2, 3), x);
    EXPECT_LT(none.high, none.low);
    EXPECT_FALSE(none.contains(2));
  }
  std::mt19937 rng(2);
  std::size_t within = 0;
  for (int trial = 0; trial < 50; ++trial) {
    const auto outline = outlineOf(randomPlaces(rng, 3));
    for (double x = -1.5; x < 1.5; x += 0.07)
      for (double y = -1.5; y < 1.5; y += 0.11) {
        EXPECT_EQ(outlineSpan(outline, x).contains(y), isWithin(outline, x, y));
        within += isWithin(outline, x, y);
      }
  }
  EXPECT_GT(within, 1000u);
}

TEST(KDop16, TheRectangleIsTheSmallest)
{
  const auto straight = outlineRectangle(rectangle(0, 0, 1, 3));
  EXPECT_EQ(straight.axis, 0u);
  EXPECT_NEAR(straight.length, 1, 1e-6);
  EXPECT_NEAR(straight.width, 3, 1e-6);
  for (std::size_t turn = 0; turn < 4; ++turn) {
    const Eigen::Vector2d u = outlineDirection(turn), v = outlineDirection(turn + 4);
    Places corners;
    for (const double along : {0.0, 2.0})
      for (const double across : {0.0, 0.5}) {
        const Eigen::Vector2d corner = along * u + across * v;
        corners.emplace_back(corner.x(), corner.y(), 0);
      }
    const auto turned = outlineRectangle(outlineOf(corners));
    EXPECT_EQ(turned.axis, turn);
    EXPECT_NEAR(turned.length, 2, 1e-5);
    EXPECT_NEAR(turned.width, 0.5, 1e-5);
  }
}
