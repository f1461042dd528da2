/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scanner/distance_volume.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::indoor;

DepthCameraOptions
camera()
{
  DepthCameraOptions options;
  options.width = 160;
  options.height = 120;
  options.focal_length = 131;
  return options;
}

/** A ball of this radius about the origin: the upper half has the label 1, the lower
 * one the label 0. */
std::vector<DepthPixel>
viewOfBall(double radius, const CameraFrame& frame)
{
  const auto options = camera();
  std::vector<DepthPixel> pixels(options.width * options.height);
  for (int i = 0; i < options.width * options.height; ++i) {
    const Eigen::Vector3d ray =
        frame.axes * rayThrough(i % options.width, i / options.width, options);
    const double a = ray.squaredNorm(), b = ray.dot(frame.position),
                 c = frame.position.squaredNorm() - radius * radius;
    if (b * b < a * c)
      continue;
    const double depth = (-b - std::sqrt(b * b - a * c)) / a;
    pixels[i] = {depth, (frame.position + depth * ray).z() > 0 ? 1 : 0};
  }
  return pixels;
}

/** From twelve places all around. */
DistanceVolume
ballInVolume(double radius, int threads)
{
  DistanceVolume volume(0.02, threads);
  for (int k = 0; k < 12; ++k) {
    const double angle = k * 2.4, z = 1.5 * (k - 5.5) / 5.5;
    const double r = std::sqrt(2.25 - std::min(z * z, 2.24));
    const auto frame = frameOf(
        {{r * std::cos(angle), r * std::sin(angle), z}, Eigen::Vector3d(0, 0, 0)});
    volume.integrate(viewOfBall(radius, frame), frame, camera());
  }
  return volume;
}

TEST(DistanceVolume, FindsABallWhereItIsWithTheLabelsOfItsHalves)
{
  const auto vertices = ballInVolume(0.5, 1).vertices(0.1f);
  // A sphere meets the lines of a grid in three directions: 6 pi r^2 / h^2 times.
  const double expected = 6 * M_PI * 0.25 / (0.02 * 0.02);
  EXPECT_NEAR(static_cast<double>(vertices.size()), expected, 0.05 * expected);
  double squares = 0;
  for (const auto& vertex : vertices) {
    const double error = vertex.at.norm() - 0.5;
    EXPECT_LT(std::abs(error), 0.02) << "a voxel";
    squares += error * error;
    if (std::abs(vertex.at.z()) >
        0.03) { // nearer to the border a voxel has both labels
      EXPECT_EQ(vertex.label, vertex.at.z() > 0 ? 1u : 0u);
    }
  }
  EXPECT_LT(std::sqrt(squares / expected), 0.005);
}

TEST(DistanceVolume, IsTheSameForAnyNumberOfThreads)
{
  const auto one = ballInVolume(0.3, 1).vertices(0.1f),
             two = ballInVolume(0.3, 2).vertices(0.1f);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].at, two[i].at);
    ASSERT_EQ(one[i].label, two[i].label);
  }
}

TEST(DistanceVolume, WhatTooFewViewsSawIsNoSurface)
{
  const auto volume = ballInVolume(0.5, 1);
  const auto all = volume.vertices(0.1f).size();
  EXPECT_LT(volume.vertices(4).size(), all);
  EXPECT_EQ(volume.vertices(1000).size(), 0u);
  EXPECT_TRUE(DistanceVolume(0.02, 1).vertices(0).empty());
}

TEST(DistanceVolume, AStrayDepthIsCarvedAway)
{
  // A wall 2 m away; in one of ten views a pixel has something 1 m before it.
  const auto options = camera();
  const auto frame = frameOf({{0, 0, 0}, {1, 0, 0}});
  std::vector<DepthPixel> wall(options.width * options.height, {2.0, 0});
  DistanceVolume volume(0.02, 1);
  auto stray = wall;
  for (int v = 58; v < 62; ++v)
    for (int u = 78; u < 82; ++u)
      stray[v * options.width + u] = {1.0, 1};
  volume.integrate(stray, frame, options);
  for (int view = 0; view < 9; ++view)
    volume.integrate(wall, frame, options);
  const auto vertices = volume.vertices(0.1f);
  EXPECT_GT(vertices.size(), 1000u);
  for (const auto& vertex : vertices)
    ASSERT_NEAR(vertex.at.x(), 2, 1e-3);
}

} // namespace
