/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/object_context.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace pcl::indoor {
namespace {

/** Points on a grid on all six faces of a box, turned about z, 10 per metre and face.
 */
std::vector<OrientedPoint>
box(const Eigen::Vector3f& size, float angle)
{
  const Eigen::AngleAxisf turn(angle, Eigen::Vector3f::UnitZ());
  std::vector<OrientedPoint> points;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-0.5f, 0.5f})
      for (int i = 0; i <= 10; ++i)
        for (int j = 0; j <= 10; ++j) {
          Eigen::Vector3f unit;
          unit[axis] = side;
          unit[(axis + 1) % 3] = static_cast<float>(i) / 10.0f - 0.5f;
          unit[(axis + 2) % 3] = static_cast<float>(j) / 10.0f - 0.5f;
          const Eigen::Vector3f normal = Eigen::Vector3f::Unit(axis) * 2.0f * side;
          points.push_back({turn * unit.cwiseProduct(size) + Eigen::Vector3f(5, -3, 1),
                            turn * normal});
        }
  return points;
}

float
logarithm(float metres)
{
  return std::log(1.0f + 10.0f * metres) / std::log(31.0f);
}

TEST(ObjectContext, SizeOfABoxHoweverItIsTurned)
{
  for (const float angle : {0.0f, 0.3f, 0.7854f, 1.2f, 1.5708f, 2.5f, -0.01f}) {
    const auto values = contextValues(box({0.6f, 1.5f, 0.8f}, angle), {});
    ASSERT_EQ(values.size(), context_value_count);
    EXPECT_NEAR(values[0], 0.8f, 1e-5f);
    EXPECT_NEAR(values[1], 1.5f, 1e-5f);
    EXPECT_NEAR(values[2], 0.6f, 1e-5f);
    EXPECT_NEAR(values[3], logarithm(0.8f), 1e-5f);
    EXPECT_NEAR(values[4], logarithm(1.5f), 1e-5f);
    EXPECT_NEAR(values[5], logarithm(0.6f), 1e-5f);
    EXPECT_FLOAT_EQ(values[6], 1.0f / 3.0f);
    EXPECT_FLOAT_EQ(values[7], 2.0f / 3.0f);
    EXPECT_NEAR(values[8], 0.5f, 1e-5f);
    EXPECT_TRUE(std::all_of(
        values.begin() + 9, values.end(), [](float value) { return value == 0.0f; }));
  }
}

TEST(ObjectContext, DirectionsAndHeight)
{
  std::vector<OrientedPoint> points(8);
  for (std::size_t k = 0; k < 8; ++k) {
    // 5, 15, ... 75 degrees from straight down
    const double angle = (5.0 + 10.0 * static_cast<double>(k)) * M_PI / 180.0;
    points[k].normal =
        Eigen::Vector3d(std::sin(angle), 0, -std::cos(angle)).cast<float>();
  }
  points[0].position.z() = 2.0f;
  points[7].position.z() = -2.0f;
  auto values = contextValues(points, {});
  EXPECT_FLOAT_EQ(values[6], 3.0f / 8.0f);
  EXPECT_FLOAT_EQ(values[7], 2.0f / 8.0f);
  EXPECT_FLOAT_EQ(values[8], 0.5f);
  EXPECT_FLOAT_EQ(values[0], 4.0f);
  EXPECT_FLOAT_EQ(values[1], 0.0f);
  points[7].position.z() = -20.0f; // longer than any furniture
  values = contextValues(points, {});
  EXPECT_FLOAT_EQ(values[0], 4.0f);
  EXPECT_FLOAT_EQ(values[8], static_cast<float>((20.0 - 18.0 / 8.0) / 22.0));
}

TEST(ObjectContext, PlaceIfItIsKnown)
{
  ObjectPlace place{false, 1.0f};
  const auto points = box({1, 1, 1}, 0);
  const auto size = contextValues(points, {});
  EXPECT_EQ(contextValues(points, place), size);
  place = {true, -0.02f};
  auto values = contextValues(points, place);
  EXPECT_TRUE(std::equal(size.begin(), size.begin() + 9, values.begin()));
  values.erase(values.begin(), values.begin() + 9);
  EXPECT_EQ(values, (std::vector<float>{0, 1, 1}));
}

TEST(ObjectContext, HeightAboveTheFloor)
{
  const auto values = contextValues(box({1, 1, 1}, 0), {true, 1.5f});
  EXPECT_EQ(std::vector<float>(values.begin() + 9, values.end()),
            (std::vector<float>{1.5f, 0, 1}));
}

TEST(ObjectContext, FewPoints)
{
  EXPECT_EQ(contextValues({}, {}), std::vector<float>(context_value_count, 0.0f));
  OrientedPoint point;
  point.position = {3, 4, 5};
  const auto one = contextValues({point, point}, {});
  EXPECT_EQ(std::vector<float>(one.begin(), one.begin() + 6),
            std::vector<float>(6, 0.0f));
  EXPECT_EQ(one[7], 1.0f); // a normal of zero is not upright
}

/** The smallest box over many directions, from all points. */
Eigen::Vector2f
triedRectangle(const std::vector<Eigen::Vector2f>& points)
{
  Eigen::Vector2f best(1e9f, 1e9f);
  for (int step = 0; step < 9000; ++step) {
    const double angle = step * M_PI / 18000.0;
    const Eigen::Vector2f along(static_cast<float>(std::cos(angle)),
                                static_cast<float>(std::sin(angle)));
    Eigen::Vector2f low(1e9f, 1e9f);
    Eigen::Vector2f high = -low;
    for (const auto& point : points) {
      const Eigen::Vector2f place(along.dot(point),
                                  along.x() * point.y() - along.y() * point.x());
      low = low.cwiseMin(place);
      high = high.cwiseMax(place);
    }
    const Eigen::Vector2f sides = high - low;
    if (sides.prod() < best.prod())
      best = sides;
  }
  return {best.maxCoeff(), best.minCoeff()};
}

TEST(SmallestRectangle, IsAsSmallAsAnyTried)
{
  std::mt19937 random(1);
  const auto number = [&random] { return static_cast<float>(random() % 10000) / 1e4f; };
  for (int repeat = 0; repeat < 60; ++repeat) {
    std::vector<Eigen::Vector2f> points(3 + static_cast<std::size_t>(repeat));
    for (auto& point : points) {
      point = {number() + 2.0f, 0.3f * number() - 1.0f};
      if (repeat % 3 == 1) { // a ring: all are corners
        const float angle = 6.2832f * number();
        point = {2.0f + std::cos(angle), 0.4f * std::sin(angle)};
      }
      if (repeat % 3 == 2) // a lattice: many on one line
        point = point.array().round() + Eigen::Array2f(random() % 4, random() % 3);
    }
    const auto found = smallestRectangle(points);
    const auto tried = triedRectangle(points);
    EXPECT_LE(found.prod(), tried.prod() + 1e-5f);
    EXPECT_GE(found.prod(), tried.prod() * 0.998f - 1e-5f);
    EXPECT_GE(found[0], found[1]);
  }
}

TEST(SmallestRectangle, OfPointsOnALine)
{
  std::vector<Eigen::Vector2f> points;
  for (int k = 0; k < 20; ++k)
    points.push_back({3.0f * k, 4.0f * k});
  const auto sides = smallestRectangle(points);
  EXPECT_FLOAT_EQ(sides[0], 95.0f);
  EXPECT_FLOAT_EQ(sides[1], 0.0f);
  EXPECT_EQ(smallestRectangle({{1, 2}, {1, 2}}), Eigen::Vector2f(0, 0));
}

} // namespace
} // namespace pcl::indoor
