/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/mesh_sampling.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using pcl::indoor::tool::Mesh;
using pcl::indoor::tool::sampleMesh;

namespace {

float
uniform(std::mt19937& rng)
{
  return static_cast<float>(rng()) / 4294967296.0f;
}

/** Triangles apart from each other, each in its own plane x = number. */
Mesh
separateTriangles(std::size_t count, std::mt19937& rng)
{
  Mesh mesh;
  for (std::size_t k = 0; k < count; ++k) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int corner = 0; corner < 3; ++corner)
      mesh.vertices.emplace_back(static_cast<float>(k), uniform(rng), uniform(rng));
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

double
areaOf(const Mesh& mesh, std::size_t triangle)
{
  const auto& t = mesh.triangles[triangle];
  const Eigen::Vector3d a = mesh.vertices[t[0]].cast<double>();
  const Eigen::Vector3d b = mesh.vertices[t[1]].cast<double>() - a;
  const Eigen::Vector3d c = mesh.vertices[t[2]].cast<double>() - a;
  return std::abs(b.y() * c.z() - b.z() * c.y()) / 2.0; // all lie across x
}

} // namespace

TEST(MeshSampling, TrianglesGetTheirShareOfThePoints)
{
  std::mt19937 rng(3);
  for (int round = 0; round < 20; ++round) {
    const auto mesh = separateTriangles(1 + rng() % 30, rng);
    double area = 0.0;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
      area += areaOf(mesh, k);
    const auto points = sampleMesh(mesh, 500, static_cast<std::uint32_t>(round));
    ASSERT_EQ(points.size(), 500u);
    std::vector<double> counts(mesh.triangles.size());
    for (const auto& point : points)
      ++counts.at(static_cast<std::size_t>(point.position.x()));
    for (std::size_t k = 0; k < counts.size(); ++k)
      EXPECT_NEAR(counts[k], 500.0 * areaOf(mesh, k) / area, 2.0) << k;
  }
}

TEST(MeshSampling, PointsLieEvenlyInATriangle)
{
  // x and y of a right triangle: each of mean 1 / 3, of the square 1 / 6, x y 1 / 12
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  Eigen::Array<double, 5, 1> sums = Eigen::Array<double, 5, 1>::Zero();
  constexpr std::size_t count = 100000;
  for (const auto& point : sampleMesh(mesh, count, 1)) {
    const double x = point.position.x(), y = point.position.y();
    ASSERT_GE(x, 0.0);
    ASSERT_GE(y, 0.0);
    ASSERT_LE(x + y, 1.0 + 1e-6);
    ASSERT_EQ(point.normal, Eigen::Vector3f(0, 0, 1));
    sums += Eigen::Array<double, 5, 1>(x, y, x * x, y * y, x * y);
  }
  const Eigen::Array<double, 5, 1> means = sums / static_cast<double>(count);
  EXPECT_NEAR(means[0], 1.0 / 3, 3e-3); // four deviations of the mean
  EXPECT_NEAR(means[1], 1.0 / 3, 3e-3);
  EXPECT_NEAR(means[2], 1.0 / 6, 3e-3);
  EXPECT_NEAR(means[3], 1.0 / 6, 3e-3);
  EXPECT_NEAR(means[4], 1.0 / 12, 1e-3);
}

TEST(MeshSampling, NormalsFollowTheOrderOfTheCorners)
{
  const Mesh mesh{{{0, 0, 0}, {0, 2, 0}, {3, 0, 0}}, {{0, 1, 2}}};
  for (const auto& point : sampleMesh(mesh, 10, 1))
    EXPECT_EQ(point.normal, Eigen::Vector3f(0, 0, -1));
}

TEST(MeshSampling, TrianglesWithoutAnAreaGetNoPoint)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Mesh mesh{
      {{5, 5, 5}, {6, 6, 6}, {7, 7, 7}, {nan, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
      {{0, 1, 2}, {0, 0, 1}, {4, 5, 3}, {4, 5, 6}, {0, 1, 2}, {3, 3, 3}}};
  const auto points = sampleMesh(mesh, 100, 1);
  ASSERT_EQ(points.size(), 100u);
  for (const auto& point : points) {
    EXPECT_EQ(point.position.z(), 0.0f);
    EXPECT_TRUE(point.normal.allFinite());
  }
}

TEST(MeshSampling, TheSeedDecides)
{
  std::mt19937 rng(4);
  const auto mesh = separateTriangles(5, rng);
  const auto first = sampleMesh(mesh, 50, 1), again = sampleMesh(mesh, 50, 1);
  const auto other = sampleMesh(mesh, 50, 2);
  for (std::size_t k = 0; k < first.size(); ++k) {
    EXPECT_EQ(first[k].position, again[k].position);
    EXPECT_NE(first[k].position, other[k].position);
  }
  EXPECT_TRUE(sampleMesh(mesh, 0, 1).empty());
}

TEST(MeshSampling, RefusesMeshesWithoutAnAreaOrWithUnknownVertices)
{
  EXPECT_THROW(sampleMesh({}, 10, 1), pcl::BadArgumentException);
  EXPECT_THROW(sampleMesh({{{0, 0, 0}}, {{0, 0, 0}}}, 10, 1),
               pcl::BadArgumentException);
  EXPECT_THROW(sampleMesh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}}, 10, 1),
               pcl::BadArgumentException);
}
