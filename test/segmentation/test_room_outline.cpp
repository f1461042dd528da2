/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/room_outline.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl::indoor;

namespace {

PixelMap<std::int32_t>
emptyMap(int nx, int ny)
{
  return {nx, ny, std::vector<std::int32_t>(static_cast<std::size_t>(nx * ny), 0)};
}

void
fill(PixelMap<std::int32_t>& map, int x0, int x1, int y0, int y1, std::int32_t label)
{
  for (int x = x0; x < x1; ++x)
    for (int y = y0; y < y1; ++y)
      map.at(x, y) = label;
}

double
area(const std::vector<OutlineRing>& rings)
{
  double sum = 0.0;
  for (const auto& ring : rings)
    sum += signedArea(ring);
  return sum;
}

bool
hasCorner(const OutlineRing& ring, int x, int y)
{
  return std::count(ring.begin(), ring.end(), Eigen::Vector2i(x, y)) == 1;
}

double
distanceToRing(const OutlineRing& ring, const Eigen::Vector2i& point)
{
  double nearest = 1e9;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i].cast<double>();
    const Eigen::Vector2d along = ring[(i + 1) % ring.size()].cast<double>() - a;
    const Eigen::Vector2d to_point = point.cast<double>() - a;
    const double part = std::clamp(to_point.dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (to_point - part * along).norm());
  }
  return nearest;
}

} // namespace

TEST(RoomOutline, ARectangleHasFourCorners)
{
  auto map = emptyMap(12, 9);
  fill(map, 2, 9, 0, 9, 1); // touches the map's edge
  const auto outlines = traceOutlines(map, 1);
  ASSERT_EQ(outlines.size(), 2u);
  EXPECT_TRUE(outlines[0].empty());
  ASSERT_EQ(outlines[1].size(), 1u);
  const auto& ring = outlines[1][0];
  EXPECT_EQ(ring.size(), 4u);
  EXPECT_TRUE(hasCorner(ring, 2, 0) && hasCorner(ring, 9, 0) && hasCorner(ring, 9, 9) &&
              hasCorner(ring, 2, 9));
  EXPECT_EQ(signedArea(ring), 63.0);
  EXPECT_EQ(simplifyOutline(ring, 1.0), ring);
}

TEST(RoomOutline, AnLShapeHasSixCorners)
{
  auto map = emptyMap(12, 12);
  fill(map, 1, 11, 1, 4, 1);
  fill(map, 1, 5, 4, 9, 1);
  const auto rings = traceOutlines(map, 1)[1];
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings[0].size(), 6u);
  EXPECT_TRUE(hasCorner(rings[0], 5, 4)); // the inner one
  EXPECT_EQ(signedArea(rings[0]), 50.0);
  EXPECT_EQ(simplifyOutline(rings[0], 1.0).size(), 6u);
  EXPECT_EQ(signedArea(simplifyOutline(rings[0], 1.0)), 50.0);
}

TEST(RoomOutline, AHoleIsAClockwiseRing)
{
  auto map = emptyMap(10, 10);
  fill(map, 0, 10, 0, 10, 1);
  fill(map, 3, 6, 4, 6, 2); // another room within it
  const auto outlines = traceOutlines(map, 2);
  ASSERT_EQ(outlines[1].size(), 2u);
  EXPECT_EQ(signedArea(outlines[1][0]), 100.0);
  EXPECT_EQ(signedArea(outlines[1][1]), -6.0);
  ASSERT_EQ(outlines[2].size(), 1u);
  EXPECT_EQ(signedArea(outlines[2][0]), 6.0);
  EXPECT_LT(signedArea(simplifyOutline(outlines[1][1], 1.0)), 0.0);
}

TEST(RoomOutline, PixelsThatTouchAtACornerAreApartAndTheLargestPartIsFirst)
{
  auto map = emptyMap(8, 8);
  fill(map, 1, 3, 1, 3, 1);
  fill(map, 3, 6, 3, 6, 1);
  const auto rings = traceOutlines(map, 1)[1];
  ASSERT_EQ(rings.size(), 2u);
  EXPECT_EQ(signedArea(rings[0]), 9.0);
  EXPECT_EQ(signedArea(rings[1]), 4.0);
  EXPECT_TRUE(traceOutlines(emptyMap(0, 0), 1)[1].empty());
  EXPECT_EQ(traceOutlines(emptyMap(4, 4), 0).size(), 1u);
}

TEST(RoomOutline, TracingConservesTheAreaOfAnyMap)
{
  std::mt19937 rng(9);
  for (int trial = 0; trial < 200; ++trial) {
    auto map = emptyMap(1 + rng() % 14, 1 + rng() % 14);
    for (auto& label : map.values)
      label = static_cast<std::int32_t>(rng() % 4);
    const auto outlines = traceOutlines(map, 3);
    for (std::int32_t label = 1; label <= 3; ++label) {
      EXPECT_EQ(area(outlines[label]),
                std::count(map.values.begin(), map.values.end(), label))
          << "trial " << trial;
      for (const auto& ring : outlines[label])
        for (std::size_t i = 0; i < ring.size(); ++i) { // at right angles all round
          const Eigen::Vector2i side = ring[(i + 1) % ring.size()] - ring[i];
          const Eigen::Vector2i next =
              ring[(i + 2) % ring.size()] - ring[(i + 1) % ring.size()];
          EXPECT_EQ(side.dot(next), 0);
          EXPECT_GT(side.squaredNorm(), 0);
        }
    }
  }
}

TEST(RoomOutline, ATurnedRectangleBecomesAFewCornersNearItsBorder)
{
  for (const double degrees : {10.0, 30.0, 45.0, 71.0}) {
    auto map = emptyMap(100, 100);
    const Eigen::Vector2d along(std::cos(degrees * M_PI / 180),
                                std::sin(degrees * M_PI / 180));
    const Eigen::Vector2d across(-along.y(), along.x());
    for (int x = 0; x < 100; ++x)
      for (int y = 0; y < 100; ++y) {
        const Eigen::Vector2d place(x + 0.5 - 50, y + 0.5 - 50);
        map.at(x, y) =
            std::abs(place.dot(along)) < 40 && std::abs(place.dot(across)) < 25;
      }
    const auto ring = traceOutlines(map, 1)[1].at(0);
    const auto simple = simplifyOutline(ring, 1.5);
    EXPECT_GT(ring.size(), 50u);
    EXPECT_GE(simple.size(), 4u) << degrees;
    EXPECT_LE(simple.size(), 8u) << degrees; // a corner of the map may stay beside one
    for (const auto& corner : ring)
      EXPECT_LE(distanceToRing(simple, corner), 1.5);
    // half a pixel along 260 of them is as much as the four lines are moved
    EXPECT_NEAR(signedArea(simple), 4000.0, 130.0) << degrees;
  }
}

TEST(RoomOutline, NoSimplerRingThatCrossesItselfOrVanishes)
{
  auto map = emptyMap(30, 3);
  for (int x = 0; x < 30; ++x) // a zigzag one pixel wide
    fill(map, x, x + 1, x % 4 == 3 ? 1 : 0, x % 4 == 1 ? 1 : 2, 1);
  const auto ring = traceOutlines(map, 1)[1].at(0);
  const auto simple = simplifyOutline(ring, 3.0);
  EXPECT_EQ(simple, ring); // all points lie within 3 pixels of one line
  EXPECT_LT(simplifyOutline(ring, 1.0).size(), ring.size());
}
