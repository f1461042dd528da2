/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/dominant_directions.h"

#include <pcl/exceptions.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace pcl::indoor;

namespace {

constexpr double degree = M_PI / 180.0;

double
uniform(std::mt19937& rng)
{
  return (rng() % 1000003) / 1000003.0;
}

double
gaussian(std::mt19937& rng) // Box and Muller
{
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(rng)));
  return radius * std::cos(2.0 * M_PI * uniform(rng));
}

Eigen::Vector3d
randomDirection(std::mt19937& rng)
{
  const double z = 2.0 * uniform(rng) - 1.0;
  const double angle = 2.0 * M_PI * uniform(rng);
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

Eigen::Matrix3d
randomRotation(std::mt19937& rng)
{
  return Eigen::AngleAxisd(2.0 * M_PI * uniform(rng), randomDirection(rng))
      .toRotationMatrix();
}

Eigen::Matrix3d
turnedByDegrees(double degrees)
{
  return Eigen::AngleAxisd(degrees * degree, Eigen::Vector3d::UnitZ())
      .toRotationMatrix();
}

void
addNormals(const Eigen::Vector3d& axis,
           int count,
           double sigma,
           std::mt19937& rng,
           std::vector<Eigen::Vector3d>& normals)
{
  const Eigen::Vector3d u = axis.unitOrthogonal();
  const Eigen::Vector3d v = axis.cross(u);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d normal =
        (axis + sigma * gaussian(rng) * u + sigma * gaussian(rng) * v).normalized();
    normals.push_back(rng() % 2 ? normal : -normal);
  }
}

void
addFrame(const Eigen::Matrix3d& axes,
         const Eigen::Vector3i& counts,
         double sigma,
         std::mt19937& rng,
         std::vector<Eigen::Vector3d>& normals)
{
  for (int axis = 0; axis < 3; ++axis)
    addNormals(axes.col(axis), counts[axis], sigma, rng, normals);
}

/** \brief The greatest angle between an axis of a and the nearest axis of b, degrees.
 */
double
difference(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b)
{
  const Eigen::Matrix3d dots = (a.transpose() * b).cwiseAbs();
  return std::acos(std::min(1.0, dots.rowwise().maxCoeff().minCoeff())) / degree;
}

double
nearestFrame(const std::vector<ManhattanFrame>& frames, const Eigen::Matrix3d& axes)
{
  double nearest = 90.0;
  for (const auto& frame : frames)
    nearest = std::min(nearest, difference(axes, frame.axes));
  return nearest;
}

/** \brief Frames of which no axis is close to one of another. */
std::vector<Eigen::Matrix3d>
distinctFrames(int count, std::mt19937& rng)
{
  std::vector<Eigen::Matrix3d> frames;
  while (static_cast<int>(frames.size()) < count) {
    const Eigen::Matrix3d axes = randomRotation(rng);
    const bool distinct = std::all_of(frames.begin(), frames.end(), [&](const auto& f) {
      return (f.transpose() * axes).cwiseAbs().maxCoeff() < std::cos(18.0 * degree);
    });
    if (distinct)
      frames.push_back(axes);
  }
  return frames;
}

} // namespace

TEST(ManhattanFrames, RecoversAnyNumberOfRandomFramesWithinOneDegree)
{
  std::mt19937 rng(31);
  for (int trial = 0; trial < 60; ++trial) {
    const int count = 1 + trial % 4;
    const auto truth = distinctFrames(count, rng);
    std::vector<Eigen::Vector3d> normals;
    for (const auto& axes : truth)
      addFrame(
          axes,
          Eigen::Vector3i(600 + rng() % 1500, 400 + rng() % 600, 300 + rng() % 900),
          4.0 * degree,
          rng,
          normals);
    const std::size_t clutter = normals.size() / 4; // 20 % from anywhere
    for (std::size_t i = 0; i < clutter; ++i)
      normals.push_back(randomDirection(rng));
    const auto frames = manhattanFrames(normals);
    EXPECT_EQ(frames.size(), truth.size()) << "trial " << trial;
    for (const auto& axes : truth)
      EXPECT_LT(nearestFrame(frames, axes), 1.0) << "trial " << trial;
    for (const auto& frame : frames) {
      EXPECT_NEAR(frame.axes.determinant(), 1.0, 1e-9);
      EXPECT_TRUE((frame.axes.transpose() * frame.axes).isIdentity(1e-9));
    }
  }
}

TEST(ManhattanFrames, FramesOfABuildingShareTheVertical)
{
  std::mt19937 rng(32);
  std::vector<Eigen::Vector3d> normals;
  addFrame(turnedByDegrees(10), {3000, 2000, 8000}, 3.0 * degree, rng, normals);
  addFrame(turnedByDegrees(40), {700, 500, 1500}, 3.0 * degree, rng, normals); // a wing
  const Eigen::Matrix3d roof =
      Eigen::AngleAxisd(35.0 * degree, turnedByDegrees(10).col(0)).toRotationMatrix() *
      turnedByDegrees(10);
  addNormals(roof.col(2), 600, 3.0 * degree, rng, normals); // a sloped ceiling
  const auto frames = manhattanFrames(normals);
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_LT(difference(turnedByDegrees(10), frames[0].axes), 1.0);
  EXPECT_LT(nearestFrame(frames, turnedByDegrees(40)), 1.0);
  EXPECT_LT(nearestFrame(frames, roof), 1.5); // one axis of its own
  EXPECT_GT(frames[0].support, frames[1].support);

  const auto directions = horizontalDirections(frames);
  ASSERT_EQ(directions.size(), 4u); // the roof has none of its own
  const double expected[] = {10, 100, 40, 130};
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector2d d(std::cos(expected[i] * degree),
                            std::sin(expected[i] * degree));
    EXPECT_GT(std::abs(directions[i].direction.dot(d)), std::cos(1.0 * degree)) << i;
    EXPECT_GT(directions[i].support, 0.01);
  }
}

TEST(ManhattanFrames, ACurvedWallIsNoFrame)
{
  std::mt19937 rng(33);
  std::vector<Eigen::Vector3d> normals;
  addFrame(turnedByDegrees(0), {3000, 2000, 5000}, 2.0 * degree, rng, normals);
  for (int i = 0; i < 2000; ++i) // a half circle
    addNormals(
        turnedByDegrees(180.0 * uniform(rng)).col(0), 1, 2.0 * degree, rng, normals);
  const auto frames = manhattanFrames(normals);
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_LT(difference(turnedByDegrees(0), frames[0].axes), 1.0);
}

TEST(ManhattanFrames, WeightsAndSignsAndOrder)
{
  std::mt19937 rng(34);
  std::vector<Eigen::Vector3d> normals;
  addFrame(turnedByDegrees(5), {500, 500, 500}, 3.0 * degree, rng, normals);
  const std::size_t first = normals.size();
  addFrame(turnedByDegrees(35), {500, 500, 0}, 3.0 * degree, rng, normals);
  std::vector<double> weights(normals.size(), 1.0);
  std::fill(weights.begin() + first, weights.end(), 0.001);
  EXPECT_EQ(manhattanFrames(normals).size(), 2u);
  ASSERT_EQ(manhattanFrames(normals, weights).size(), 1u);
  const auto before = manhattanFrames(normals, weights);
  for (auto& normal : normals)
    normal = -normal;
  std::reverse(normals.begin(), normals.end());
  std::reverse(weights.begin(), weights.end());
  const auto after = manhattanFrames(normals, weights);
  // The arc cosine of a number close to 1 is no better than this.
  EXPECT_LT(difference(before[0].axes, after[0].axes), 1e-5);
  EXPECT_NEAR(before[0].support, after[0].support, 1e-9);
}

TEST(ManhattanFrames, NoNormalsOneNormalAndNoise)
{
  EXPECT_TRUE(manhattanFrames({}).empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(manhattanFrames({{nan, 0, 0}}).empty());
  const auto one = manhattanFrames({{0, 0.6, 0.8}});
  ASSERT_EQ(one.size(), 1u);
  EXPECT_LT(
      (one[0].axes.transpose() * Eigen::Vector3d(0, 0.6, 0.8)).cwiseAbs().maxCoeff() -
          1.0,
      1e-9);
  std::mt19937 rng(35);
  std::vector<Eigen::Vector3d> noise;
  for (int i = 0; i < 20000; ++i)
    noise.push_back(randomDirection(rng));
  EXPECT_TRUE(manhattanFrames(noise).empty());
}

TEST(HorizontalDirections, FallsBackToTheAxes)
{
  const auto directions = horizontalDirections({});
  ASSERT_EQ(directions.size(), 2u);
  EXPECT_EQ(directions[0].direction, Eigen::Vector2d::UnitX());
  EXPECT_EQ(directions[1].direction, Eigen::Vector2d::UnitY());
}

TEST(ManhattanFrames, RefusesBadArguments)
{
  const std::vector<Eigen::Vector3d> normals{{1, 0, 0}};
  EXPECT_THROW(manhattanFrames(normals, {1, 2}), pcl::BadArgumentException);
  EXPECT_THROW(manhattanFrames(normals, {-1}), pcl::BadArgumentException);
}
