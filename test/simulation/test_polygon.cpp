/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/polygon.h>
#include <pcl/simulation/random_draw.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::indoor;

const Polygon square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const Polygon ell{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};

// A star-shaped polygon: simple, seldom convex.
Polygon
drawStar(int vertices, RandomDraw& draw)
{
  Polygon polygon;
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2 * M_PI * i / vertices, radius = draw.uniform(1.0, 5.0);
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

TEST(Polygon, TrianglesCoverItOnce)
{
  RandomDraw draw(3);
  for (int trial = 0; trial < 100; ++trial) {
    const auto polygon = drawStar(3 + draw.pick(20), draw);
    const auto triangles = triangulate(polygon);
    ASSERT_EQ(triangles.size(), polygon.size() - 2);
    double area = 0;
    for (const auto& t : triangles) {
      const Polygon triangle{polygon[t[0]], polygon[t[1]], polygon[t[2]]};
      EXPECT_GE(signedArea(triangle), 0.0);
      area += signedArea(triangle);
      const Eigen::Vector2d middle = (triangle[0] + triangle[1] + triangle[2]) / 3;
      EXPECT_TRUE(contains(polygon, middle)) << "trial " << trial;
    }
    EXPECT_NEAR(area, signedArea(polygon), 1e-9); // rounding of about 20 products
  }
}

TEST(Polygon, VerticesOnAStraightLineAreHandled)
{
  const Polygon polygon{{0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 4}, {0, 4}, {0, 2}};
  double area = 0;
  for (const auto& t : triangulate(polygon))
    area += signedArea({polygon[t[0]], polygon[t[1]], polygon[t[2]]});
  EXPECT_DOUBLE_EQ(area, 16.0);
  EXPECT_NEAR(signedArea(inset(polygon, 0.5)), 9.0, 1e-12);
}

TEST(Polygon, InsetMovesEveryEdge)
{
  EXPECT_NEAR(signedArea(inset(square, 0.1)), 3.8 * 3.8, 1e-12);
  const auto inner = inset(ell, 0.1);
  ASSERT_EQ(inner.size(), ell.size());
  EXPECT_NEAR(inner[3].x(), 1.9, 1e-12); // the corner that points inwards
  EXPECT_NEAR(inner[3].y(), 1.9, 1e-12);
  for (const auto& vertex : inner)
    EXPECT_GE(distanceToBoundary(ell, vertex), 0.1 - 1e-12);
}

TEST(Polygon, SeesWhenItCrossesItself)
{
  EXPECT_FALSE(crossesItself(square));
  EXPECT_FALSE(crossesItself(ell));
  EXPECT_TRUE(crossesItself({{0, 0}, {4, 4}, {4, 0}, {0, 4}})); // bow tie
  EXPECT_TRUE(crossesItself({{0, 0}, {4, 0}, {2, 0}, {2, 4}})); // folds back
  EXPECT_TRUE(crossesItself({{0, 0}, {4, 0}, {4, 0}, {4, 4}})); // doubled vertex
  EXPECT_TRUE(crossesItself({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})); // touches
}

TEST(Polygon, OverlapsOnlyWithInsidesInCommon)
{
  const auto moved = [](double x, double y) {
    Polygon polygon = square;
    for (auto& p : polygon)
      p += Eigen::Vector2d(x, y);
    return polygon;
  };
  EXPECT_TRUE(overlap(square, square));
  EXPECT_TRUE(overlap(square, moved(3.9, 0)));
  EXPECT_FALSE(overlap(square, moved(4, 0))); // share a wall
  EXPECT_FALSE(overlap(square, moved(4, 4))); // share a corner
  EXPECT_TRUE(overlap(square, inset(square, 1.0)));
  EXPECT_TRUE(overlap(inset(square, 1.0), square));
  EXPECT_FALSE(overlap(ell, inset(moved(2, 2), 0.01))); // in the corner of the L
}

TEST(Polygon, DistanceToSegmentHasThreeCases)
{
  const Eigen::Vector2d a(0, 0), b(4, 0);
  EXPECT_DOUBLE_EQ(distanceToSegment({2, 3}, a, b), 3.0);
  EXPECT_DOUBLE_EQ(distanceToSegment({-3, 4}, a, b), 5.0);
  EXPECT_DOUBLE_EQ(distanceToSegment({7, -4}, a, b), 5.0);
  EXPECT_DOUBLE_EQ(distanceToSegment({3, 4}, a, a), 5.0);
}

} // namespace
