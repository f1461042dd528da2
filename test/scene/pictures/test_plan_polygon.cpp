/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/plan_polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace pcl::indoor::tool;

namespace {

PlanRing
square(double x, double y, double side)
{
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

PlanRing
hole(double x, double y, double side)
{
  auto ring = square(x, y, side);
  std::reverse(ring.begin(), ring.end());
  return ring;
}

} // namespace

TEST(PlanPolygon, HolesBelongToThePieceAroundThem)
{
  const std::vector<PlanRing> rings = {
      square(0, 0, 4), hole(11, 1, 1), square(10, 0, 5), hole(1, 1, 2), hole(30, 0, 1)};
  const auto polygons = polygonsOf(rings);
  ASSERT_EQ(polygons.size(), 2u);
  ASSERT_EQ(polygons[0].holes.size(), 1u);
  EXPECT_EQ(signedArea(polygons[0].holes[0]), -4.0);
  ASSERT_EQ(polygons[1].holes.size(), 1u);
  EXPECT_EQ(signedArea(polygons[1].holes[0]), -1.0);
  EXPECT_EQ(perimeter(polygons[1].outer), 20.0);
  EXPECT_TRUE(polygonsOf({{{0, 0}, {1, 0}, {2, 0}}}).empty());
  EXPECT_TRUE(polygonsOf({}).empty());
}

TEST(PlanPolygon, PlacesInHolesAreOutside)
{
  const std::vector<PlanRing> rings = {square(0, 0, 4), hole(1, 1, 2)};
  EXPECT_TRUE(isInside(rings, {0.5, 2.0}));
  EXPECT_FALSE(isInside(rings, {2.0, 2.0}));
  EXPECT_FALSE(isInside(rings, {5.0, 2.0}));
  EXPECT_DOUBLE_EQ(distanceToSides(rings, {0.3, 2.0}), 0.3);
  EXPECT_DOUBLE_EQ(distanceToSides(rings, {7.0, 8.0}), 5.0);
  EXPECT_TRUE(std::isinf(distanceToSides({}, {0.0, 0.0})));
}

TEST(PlanPolygon, TheWidestPlaceIsThatOfTheLargestCircle)
{
  EXPECT_LT((widestPlace({square(2, 3, 4)}) - Eigen::Vector2d(4.0, 5.0)).norm(), 0.05);
  // an L with a wide end
  const std::vector<PlanRing> l = {{{0, 0}, {10, 0}, {10, 4}, {6, 4}, {6, 1}, {0, 1}}};
  const auto place = widestPlace(l);
  EXPECT_GT(distanceToSides(l, place), 2.0 - 0.02);
  EXPECT_TRUE(isInside(l, place));
  const std::vector<PlanRing> ring = {square(0, 0, 4), hole(1, 1, 2)};
  EXPECT_TRUE(isInside(ring, widestPlace(ring)));
  const std::vector<PlanRing> spike = {{{0, 0}, {1e9, 0.5}, {0, 1}}}; // ends
  EXPECT_TRUE(isInside(spike, widestPlace(spike)));
  EXPECT_EQ(widestPlace({}), Eigen::Vector2d::Zero());
}
