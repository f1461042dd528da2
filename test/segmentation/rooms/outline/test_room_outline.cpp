/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/outline/room_outline.h"
#include "rooms/outline/wall_points.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include "segmentation/rooms/outline/empty_map.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl::indoor;
using pcl::indoor::test::emptyMap;

namespace {

void
fill(PixelMap<std::int32_t>& map, int x0, int x1, int y0, int y1, std::int32_t label)
{
  for (int x = x0; x < x1; ++x)
    for (int y = y0; y < y1; ++y)
      map.at(x, y) = label;
}

using Line = std::vector<Eigen::Vector2d>;

double
areaOf(const Line& line)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Eigen::Vector2d& next = line[(i + 1) % line.size()];
    twice += line[i].x() * next.y() - next.x() * line[i].y();
  }
  return 0.5 * twice;
}

Line
asLine(const OutlineRing& ring)
{
  Line line;
  for (const auto& corner : ring)
    line.push_back(corner.cast<double>());
  return line;
}

double
area(const std::vector<OutlineRing>& rings)
{
  double sum = 0.0;
  for (const auto& ring : rings)
    sum += ringArea(ring);
  return sum;
}

bool
hasCorner(const OutlineRing& ring, int x, int y)
{
  return std::count(ring.begin(), ring.end(), Eigen::Vector2i(x, y)) == 1;
}

double
distanceToRing(const Line& ring, const Eigen::Vector2i& point)
{
  double nearest = 1e9;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i];
    const Eigen::Vector2d along = ring[(i + 1) % ring.size()] - a;
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
  EXPECT_EQ(ringArea(ring), 63.0);
  const Line corners{{2, 0}, {9, 0}, {9, 9}, {2, 9}};
  EXPECT_EQ(simplifyOutline(ring, 1.0), corners);
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
  EXPECT_EQ(ringArea(rings[0]), 50.0);
  EXPECT_EQ(simplifyOutline(rings[0], 1.0).size(), 6u);
  EXPECT_NEAR(areaOf(simplifyOutline(rings[0], 1.0)), 50.0, 1e-9);
}

TEST(RoomOutline, AHoleIsAClockwiseRing)
{
  auto map = emptyMap(10, 10);
  fill(map, 0, 10, 0, 10, 1);
  fill(map, 3, 6, 4, 6, 2); // another room within it
  const auto outlines = traceOutlines(map, 2);
  ASSERT_EQ(outlines[1].size(), 2u);
  EXPECT_EQ(ringArea(outlines[1][0]), 100.0);
  EXPECT_EQ(ringArea(outlines[1][1]), -6.0);
  ASSERT_EQ(outlines[2].size(), 1u);
  EXPECT_EQ(ringArea(outlines[2][0]), 6.0);
  EXPECT_NEAR(areaOf(simplifyOutline(outlines[1][1], 1.0)), -6.0, 1e-9);
}

TEST(RoomOutline, PixelsThatTouchAtACornerAreApartAndTheLargestPartIsFirst)
{
  auto map = emptyMap(8, 8);
  fill(map, 1, 3, 1, 3, 1);
  fill(map, 3, 6, 3, 6, 1);
  const auto rings = traceOutlines(map, 1)[1];
  ASSERT_EQ(rings.size(), 2u);
  EXPECT_EQ(ringArea(rings[0]), 9.0);
  EXPECT_EQ(ringArea(rings[1]), 4.0);
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
    auto map = emptyMap(120, 100);
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
    // a tenth of a pixel along the 260 of the border
    EXPECT_NEAR(areaOf(simple), ringArea(ring), 26.0) << degrees;
  }
}

TEST(RoomOutline, NoSimplerRingThatCrossesItselfOrVanishes)
{
  auto map = emptyMap(30, 3);
  for (int x = 0; x < 30; ++x) // a zigzag one pixel wide
    fill(map, x, x + 1, x % 4 == 3 ? 1 : 0, x % 4 == 1 ? 1 : 2, 1);
  const auto ring = traceOutlines(map, 1)[1].at(0);
  const auto simple = simplifyOutline(ring, 3.0);
  EXPECT_EQ(simple, asLine(ring)); // all points lie within 3 pixels of one line
  EXPECT_LT(simplifyOutline(ring, 1.0).size(), ring.size());
}

TEST(RoomOutline, AJaggedBorderKeepsItsAreaWithFourCorners)
{
  std::mt19937 rng(3);
  auto map = emptyMap(60, 40);
  fill(map, 5, 55, 5, 35, 1);
  for (int x = 6; x < 54; ++x) { // every second pixel or so is missing
    map.at(x, 5) = static_cast<std::int32_t>(rng() % 2);
    map.at(x, 34) = static_cast<std::int32_t>(rng() % 2);
  }
  const auto ring = traceOutlines(map, 1)[1].at(0);
  const auto simple = simplifyOutline(ring, 1.5);
  EXPECT_GT(ring.size(), 40u);
  EXPECT_EQ(simple.size(), 4u);
  EXPECT_NEAR(areaOf(simple), ringArea(ring), 1.0);
}

namespace {

using Line = std::vector<Eigen::Vector2d>;

} // namespace

TEST(RoomOutline, WallPointsAreFoundAlongLines)
{
  std::mt19937 rng(6);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const auto somewhere = [&] {
    return Eigen::Vector2d(300 * part(rng) - 100, 100 * part(rng));
  };
  Line points;
  for (int i = 0; i < 5000; ++i)
    points.push_back(somewhere());
  const WallPoints index(points);
  Line found;
  std::size_t all = 0;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d a = somewhere();
    Eigen::Vector2d b = a + 0.3 * (somewhere() - a);
    if (i % 4 < 2)
      b[i % 2] = a[i % 2];
    index.alongLine(a, b, 2.0, found);
    all += found.size();
    for (const auto& point : points) {
      const Eigen::Vector2d to = b - a;
      const double along = std::clamp(to.dot(point - a) / to.squaredNorm(), 0.0, 1.0);
      if ((a + along * to - point).norm() <= 2.0) {
        ASSERT_NE(std::find(found.begin(), found.end(), point), found.end());
      }
    }
  }
  EXPECT_LT(all, 200 * points.size() / 10); // or looking for them would be for nothing
  WallPoints().alongLine({0, 0}, {1, 1}, 2.0, found);
  EXPECT_TRUE(found.empty());
  WallPoints({{1, 2}}).alongLine({0, 2}, {1e9, 2}, 2.0, found);
  EXPECT_EQ(found.size(), 1u);
}
