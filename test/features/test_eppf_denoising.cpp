/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/eppf_denoising.h>
#include <pcl/features/pair_sampling.h>

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include "features/oriented_shapes.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {
namespace {

PointNoise
noiseOf(const std::vector<OrientedPoint>& points)
{
  return measureNoise(points, spaceFillingOrder(points), objectExtent(points));
}

DenoisedObject
cleaned(const std::vector<OrientedPoint>& points, unsigned int threads = 1)
{
  return denoised(points,
                  spaceFillingOrder(points),
                  objectExtent(points),
                  noiseOf(points),
                  threads);
}

/** \brief Root mean square distance to the surface of the box. */
double
distanceToBox(const std::vector<OrientedPoint>& points)
{
  double sum = 0.0;
  for (const auto& point : points) {
    const Eigen::Array3f inside =
        point.position.array().max(0.0f).min(box_size.array());
    float distance = (point.position - inside.matrix()).norm();
    if (!(distance > 0.0f))
      distance = inside.min(box_size.array() - inside).minCoeff();
    sum += static_cast<double>(distance) * distance;
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

TEST(MeasureNoise, FindsNoneOnSurfaces)
{
  for (std::uint32_t seed = 0; seed < 20; ++seed)
    for (const std::size_t count : {256u, 2048u, 20000u}) {
      const auto noise = noiseOf(boxSurface(box_size, count, seed));
      EXPECT_EQ(noise.evidence, 0.0f);
      EXPECT_EQ(noise.deviation, 0.0f);
    }
}

TEST(MeasureNoise, FindsTheDeviation)
{
  for (std::uint32_t seed = 0; seed < 10; ++seed)
    for (const float deviation : {0.05f, 0.07f}) {
      const auto noise = noiseOf(noisyBox(box_size, deviation, 2048, seed));
      EXPECT_EQ(noise.evidence, 1.0f);
      // The box is 0.3 thin: its other sides are within reach of the planes, which adds
      // to the residual; the window hides up to a quarter of the noise.
      EXPECT_GT(noise.deviation, 0.75f * deviation);
      EXPECT_LT(noise.deviation, 1.4f * deviation);
    }
}

TEST(MeasureNoise, LeavesNoiseFinerThanThePoints)
{
  // 2,048 points on a surface of 3 extents^2 are 0.038 extents apart.
  const float spacing = 0.038f * box_size.norm();
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    EXPECT_EQ(noiseOf(noisyBox(box_size, 0.35f * spacing, 2048, seed)).evidence, 0.0f);
    EXPECT_EQ(noiseOf(noisyBox(box_size, 1.1f * spacing, 2048, seed)).evidence, 1.0f);
  }
}

TEST(MeasureNoise, DependsOnNeitherOrderNorThreads)
{
  auto points = noisyBox(box_size, 0.06f, 2048, 6);
  const auto noise = noiseOf(points);
  ASSERT_EQ(noise.evidence, 1.0f);
  std::reverse(points.begin(), points.end());
  const auto order = spaceFillingOrder(points);
  for (const unsigned int threads : {1u, 2u, 5u, 0u}) {
    const auto again = measureNoise(points, order, objectExtent(points), threads);
    EXPECT_EQ(noise.evidence, again.evidence);
    EXPECT_EQ(noise.deviation, again.deviation);
  }
}

TEST(MeasureNoise, IsNotTriedOnFewOrCoincidingPoints)
{
  EXPECT_EQ(noiseOf(noisyBox(box_size, 0.1f, 255, 1)).evidence, 0.0f);
  EXPECT_EQ(noiseOf({}).evidence, 0.0f);
  std::vector<OrientedPoint> points(1000);
  points.back().position.x() = 1.0f;
  EXPECT_EQ(noiseOf(points).evidence, 0.0f);
}

TEST(Denoised, BringsPointsNearerToTheSurface)
{
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    const auto points = noisyBox(box_size, 0.05f, 2048, seed);
    const auto object = cleaned(points);
    // A plane of some dozen points has a fraction of the noise of one; edges are bent.
    EXPECT_LT(distanceToBox(object.points), 0.75 * distanceToBox(points));
    EXPECT_LT(object.extent, objectExtent(points));
    EXPECT_GT(object.extent, 0.8f * box_size.norm());
  }
}

TEST(Denoised, EqualsPlanesThroughAllPoints)
{
  const auto points = noisyBox(box_size, 0.06f, 700, 3);
  const auto order = spaceFillingOrder(points);
  const auto noise = noiseOf(points);
  ASSERT_EQ(noise.evidence, 1.0f);
  const auto object = cleaned(points);
  const double width = 1.2 * noise.deviation;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Eigen::Vector3d place = points[order[k]].position.cast<double>();
    double sum = 0.0;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    for (const auto& point : points) {
      const Eigen::Vector3d d = point.position.cast<double>() - place;
      const double w =
          std::pow(std::max(0.0, 1.0 - d.squaredNorm() / (2 * 16 * width * width)), 16);
      sum += w;
      mean += w * d;
      moment += w * d * d.transpose();
    }
    mean /= sum;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
        moment / sum - mean * mean.transpose());
    const double ratio = solver.eigenvalues()[0] / solver.eigenvalues()[1];
    // Points farther than 3 widths, of weight 0.008, may be left out.
    EXPECT_NEAR(object.weights[k], std::max(1.0 - ratio, 0.02), 0.05);
    if (ratio > 0.8)
      continue; // two directions are as good as each other
    const Eigen::Vector3d normal = solver.eigenvectors().col(0);
    const Eigen::Vector3d moved = place + normal * normal.dot(mean);
    EXPECT_NEAR(
        (object.points[k].position.cast<double>() - moved).norm(), 0.0, 0.05 * width);
    EXPECT_EQ(object.points[k].normal, points[order[k]].normal);
  }
}

TEST(Denoised, DependsOnNeitherOrderNorThreads)
{
  auto points = noisyBox(box_size, 0.06f, 1500, 4);
  const auto object = cleaned(points);
  std::reverse(points.begin(), points.end());
  for (const unsigned int threads : {1u, 2u, 5u, 0u}) {
    const auto again = cleaned(points, threads);
    EXPECT_EQ(object.weights, again.weights);
    EXPECT_EQ(object.extent, again.extent);
    for (std::size_t k = 0; k < points.size(); ++k)
      ASSERT_EQ(object.points[k].position, again.points[k].position);
  }
}

TEST(Denoised, LargeObjectsAreThinnedEvenly)
{
  const auto points = noisyBox(box_size, 0.05f, 10000, 5);
  const auto object = cleaned(points);
  EXPECT_EQ(object.points.size(), 4096u);
  EXPECT_LT(distanceToBox(object.points), 0.75 * distanceToBox(points));
}

} // namespace
} // namespace pcl::indoor
