/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/random_draw.h>
#include <pcl/simulation/ray_tracer.h>

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace pcl::indoor;

constexpr float infinity = std::numeric_limits<float>::infinity();

Eigen::Vector3f
drawVector(RandomDraw& draw, double extent)
{
  const double x = draw.uniform(-extent, extent), y = draw.uniform(-extent, extent);
  return Eigen::Vector3d(x, y, draw.uniform(-extent, extent)).cast<float>();
}

std::vector<Triangle>
drawTriangles(int count, double size, RandomDraw& draw)
{
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3f corner = drawVector(draw, 5.0);
    triangles.push_back(
        {corner, corner + drawVector(draw, size), corner + drawVector(draw, size)});
  }
  return triangles;
}

RayHit
traceBruteForce(const std::vector<Triangle>& triangles,
                const Eigen::Vector3f& origin,
                const Eigen::Vector3f& direction,
                float min_distance,
                float max_distance)
{
  RayHit best;
  best.distance = max_distance;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const float distance = intersect(origin, direction, triangles[i]);
    if (distance >= min_distance && distance < best.distance)
      best = {distance, static_cast<int>(i)};
  }
  return best.triangle < 0 ? RayHit() : best;
}

TEST(RayTracer, EqualsBruteForce)
{
  RandomDraw draw(42);
  int hits = 0, rays = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const auto triangles =
        drawTriangles(1 + draw.pick(300), draw.uniform(0.2, 4.0), draw);
    const RayTracer tracer(triangles);
    for (int i = 0; i < 200; ++i, ++rays) {
      const Eigen::Vector3f origin = drawVector(draw, 6.0);
      const Eigen::Vector3f direction = drawVector(draw, 1.0).normalized();
      const float nearest = i % 3 == 0 ? 0.5f : 0.0f;
      const float farthest = i % 2 == 0 ? infinity : 4.0f;
      const auto expected =
          traceBruteForce(triangles, origin, direction, nearest, farthest);
      const auto hit = tracer.trace(origin, direction, nearest, farthest);
      // The same arithmetic on the same numbers: exactly equal.
      ASSERT_EQ(hit.triangle, expected.triangle) << "trial " << trial << ", ray " << i;
      ASSERT_EQ(hit.distance, expected.distance);
      hits += hit.triangle >= 0 ? 1 : 0;
    }
  }
  EXPECT_GT(hits, rays / 10);
  EXPECT_LT(hits, rays * 9 / 10);
}

TEST(RayTracer, RaysAlongTheAxesMeetFlatTriangles)
{
  RandomDraw draw(7);
  std::vector<Triangle> triangles; // all in planes of constant z, y or x
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3f corner = drawVector(draw, 5.0);
    Eigen::Vector3f b = drawVector(draw, 3.0), c = drawVector(draw, 3.0);
    b[i % 3] = c[i % 3] = 0.0f;
    triangles.push_back({corner, corner + b, corner + c});
  }
  const RayTracer tracer(triangles);
  int hits = 0;
  for (int i = 0; i < 600; ++i) {
    const Eigen::Vector3f origin = drawVector(draw, 5.0);
    const Eigen::Vector3f direction =
        Eigen::Vector3f::Unit(i % 3) * (i % 2 == 0 ? 1.0f : -1.0f);
    const auto expected = traceBruteForce(triangles, origin, direction, 0.0f, infinity);
    const auto hit = tracer.trace(origin, direction);
    ASSERT_EQ(hit.triangle, expected.triangle) << "ray " << i;
    hits += hit.triangle >= 0 ? 1 : 0;
  }
  EXPECT_GT(hits, 300);
}

TEST(RayTracer, EqualTrianglesGiveTheFirst)
{
  const Triangle triangle{{-1, -1, 2}, {1, -1, 2}, {0, 1, 2}};
  const RayTracer tracer(std::vector<Triangle>(50, triangle));
  const auto hit = tracer.trace({0, 0, 0}, {0, 0, 1});
  EXPECT_EQ(hit.triangle, 0);
  EXPECT_FLOAT_EQ(hit.distance, 2.0f);
}

TEST(RayTracer, MeasuresInLengthsOfTheDirection)
{
  const RayTracer tracer({{{-1, -1, 2}, {1, -1, 2}, {0, 1, 2}}});
  EXPECT_FLOAT_EQ(tracer.trace({0, 0, 0}, {0, 0, 4}).distance, 0.5f);
}

TEST(RayTracer, NothingToHit)
{
  EXPECT_EQ(RayTracer({}).trace({0, 0, 0}, {0, 0, 1}).triangle, -1);
  const RayTracer one({{{-1, -1, 2}, {1, -1, 2}, {0, 1, 2}}});
  EXPECT_EQ(one.trace({0, 0, 0}, {0, 0, -1}).triangle, -1);
  EXPECT_EQ(one.trace({0, 0, 0}, {0, 0, -1}).distance, infinity);
  EXPECT_EQ(one.trace({0, 0, 0}, {0, 0, 1}, 0.0f, 1.9f).triangle, -1);
  EXPECT_EQ(one.trace({0, 0, 0}, {0, 0, 1}, 2.1f).triangle, -1);
  // A ray past it, with no end: the bounding box is met, the triangle is not.
  EXPECT_EQ(one.trace({0.9f, 0.9f, 0}, {0, 0, 1}).triangle, -1);
}

} // namespace
