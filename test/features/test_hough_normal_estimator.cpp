/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/labelled_points.h"

#include <pcl/exceptions.h>
#include <pcl/features/hough_normal_estimator.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

using namespace pcl::indoor;

namespace {

constexpr float degree = 3.14159265f / 180;

float
minusOneToOne(std::mt19937& rng)
{
  return static_cast<float>(rng() % 20001) / 10000 - 1;
}

Eigen::Vector3f
randomDirection(std::mt19937& rng)
{
  for (;;) {
    const Eigen::Vector3f v(minusOneToOne(rng), minusOneToOne(rng), minusOneToOne(rng));
    if (v.norm() > 0.1f && v.norm() <= 1)
      return v.normalized();
  }
}

/** The angle between two undirected directions. */
float
angle(const Eigen::Vector3f& a, const Eigen::Vector3f& b)
{
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

/** Points of a disc of radius 1 around the origin. */
std::vector<Eigen::Vector3f>
disc(const Eigen::Vector3f& normal, int count, float noise, std::mt19937& rng)
{
  const auto u = normal.unitOrthogonal();
  const Eigen::Vector3f v = normal.cross(u);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < count; ++i)
    points.push_back(minusOneToOne(rng) * u + minusOneToOne(rng) * v +
                     noise * minusOneToOne(rng) * normal);
  return points;
}

/** The paper's method: every triple has a vote, the mean of a bin is the normal. */
HoughNormalOptions
plainOptions()
{
  HoughNormalOptions options;
  options.rotations = 1;
  options.sampling = HoughSampling::Points;
  options.choice = HoughChoice::Best;
  options.plane_distance = 1;
  options.refine = false;
  return options;
}

} // namespace

TEST(HoughAccumulator, ADirectionAndItsOppositeAreInOneBin)
{
  std::mt19937 rng(1);
  const HoughAccumulator accumulator(12, 5, 3);
  for (int i = 0; i < 1000; ++i) {
    const auto direction = randomDirection(rng);
    const auto* bins = accumulator.bins(direction);
    const auto* opposite = accumulator.bins(-7 * direction);
    for (unsigned copy = 0; copy < accumulator.rotations(); ++copy) {
      EXPECT_LT(bins[copy], accumulator.binCount());
      EXPECT_EQ(bins[copy], opposite[copy]);
    }
  }
}

TEST(HoughAccumulator, BinsAreSmallAndOfSimilarSize)
{
  std::mt19937 rng(2);
  const float bin_angle = 12;
  const HoughAccumulator accumulator(bin_angle, 3, 3);
  constexpr int draws = 100000;
  for (unsigned copy = 0; copy < 3; ++copy) {
    std::vector<int> size(accumulator.binCount(), 0);
    std::vector<Eigen::Vector3f> member(accumulator.binCount());
    for (int i = 0; i < draws; ++i) {
      const auto direction = randomDirection(rng);
      const auto bin = accumulator.bins(direction)[copy];
      if (size[bin]++ == 0)
        member[bin] = direction;
      // The diagonal of a bin, and a cell of the table on either side.
      EXPECT_LT(angle(direction, member[bin]), 1.7f * bin_angle * degree);
    }
    const int expected = draws / static_cast<int>(accumulator.binCount());
    for (const auto count : size) {
      EXPECT_GT(count, expected / 3);
      EXPECT_LT(count, expected * 3);
    }
  }
}

TEST(HoughNormal, TripleCountIsHoeffdingsBound)
{
  // ln(2 * 100 / 0.05) / (2 * 0.01) = 414.7
  EXPECT_EQ(houghTripleCount(100, 0.95, 0.1), 415u);
  HoughNormalOptions options;
  const HoughNormalEstimator estimator(options);
  const HoughAccumulator accumulator(options.bin_angle_degrees, 1, 0);
  EXPECT_EQ(
      estimator.tripleCount(),
      houghTripleCount(accumulator.binCount(), options.confidence, options.deviation));
  options.triples = 17;
  EXPECT_EQ(HoughNormalEstimator(options).tripleCount(), 17u);
}

TEST(HoughNormal, PlanesAreExact)
{
  std::mt19937 rng(3);
  for (const bool refine : {false, true})
    for (const auto sampling : {HoughSampling::Points, HoughSampling::Cubes})
      for (const auto choice :
           {HoughChoice::Best, HoughChoice::Mean, HoughChoice::Cluster}) {
        HoughNormalOptions options;
        options.refine = refine;
        options.sampling = sampling;
        options.choice = choice;
        HoughNormalEstimator estimator(options);
        for (int trial = 0; trial < 20; ++trial) {
          const auto normal = randomDirection(rng);
          auto points = disc(normal, 40, 0, rng);
          const auto found = estimator.estimate(points);
          // The rounding of the positions, magnified by thin triangles.
          EXPECT_LT(angle(found.normal, normal), 1e-4f);
          EXPECT_NEAR(found.normal.norm(), 1, 1e-5f);
          EXPECT_NEAR(found.curvature, 0, 1e-6f);
          EXPECT_GT(found.share, 0.9f);
        }
      }
}

TEST(HoughNormal, IsTheModeOfAllTriples)
{
  std::mt19937 rng(4);
  auto options = plainOptions();
  options.triples = 20000;
  options.bin_angle_degrees = 20;
  HoughNormalEstimator estimator(options);
  const HoughAccumulator accumulator(20, 1, options.seed);
  int judged = 0;
  for (int trial = 0; trial < 60; ++trial) {
    auto points = disc(randomDirection(rng), 9, 0.1f, rng);
    for (const auto& point : disc(randomDirection(rng), 7, 0.1f, rng))
      points.push_back(point);
    std::vector<int> votes(accumulator.binCount(), 0);
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (std::size_t k = 0; k < j; ++k)
          ++votes[accumulator.bins(
              (points[j] - points[i]).cross(points[k] - points[i]))[0]];
    const auto mode = std::max_element(votes.begin(), votes.end());
    auto sorted = votes;
    std::sort(sorted.rbegin(), sorted.rend());
    const auto found = estimator.estimate(points);
    if (sorted[0] < sorted[1] + 30) // of 560: the best of 20000 draws may be either
      continue;
    ++judged;
    EXPECT_EQ(accumulator.bins(found.normal)[0], mode - votes.begin()) << trial;
  }
  EXPECT_GE(judged, 20);
}

TEST(HoughNormal, StopsEarlyWhereItIsSure)
{
  std::mt19937 rng(5);
  HoughNormalEstimator estimator(plainOptions());
  auto flat = disc({0, 0, 1}, 50, 0, rng);
  EXPECT_LE(estimator.estimate(flat).triples, 16u);
  std::vector<Eigen::Vector3f> cloud;
  for (int i = 0; i < 50; ++i)
    cloud.emplace_back(minusOneToOne(rng), minusOneToOne(rng), minusOneToOne(rng));
  EXPECT_EQ(estimator.estimate(cloud).triples, estimator.tripleCount());
}

TEST(HoughNormal, DoesNotDependOnTheOrder)
{
  std::mt19937 rng(6);
  HoughNormalEstimator estimator({});
  auto points = disc({0, 0, 1}, 60, 0.2f, rng);
  points[5] = points[6];
  points[7] = -points[8]; // equally far
  const auto expected = estimator.estimate(points).normal;
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<Eigen::Vector3f> shuffled;
    for (const auto i : test::shuffledOrder(points.size(), rng))
      shuffled.push_back(points[i]);
    EXPECT_EQ(estimator.estimate(shuffled).normal, expected);
  }
}

TEST(HoughNormal, TheSeedDecides)
{
  std::mt19937 rng(7);
  const auto points = disc({0, 0, 1}, 60, 0.2f, rng);
  auto options = plainOptions();
  auto copy = points;
  const auto first = HoughNormalEstimator(options).estimate(copy).normal;
  EXPECT_EQ(HoughNormalEstimator(options).estimate(copy).normal, first);
  options.seed = 6;
  EXPECT_NE(HoughNormalEstimator(options).estimate(copy).normal, first);
}

TEST(HoughNormal, ThePlaneMustPassThePoint)
{
  std::mt19937 rng(8);
  // The point lies on a small plane beside a larger one.
  auto points = disc({0, 0, 1}, 30, 0, rng);
  for (const auto& point : disc({1, 0, 0}, 60, 0, rng))
    points.push_back(point + Eigen::Vector3f(0.8f, 0, 0));
  auto options = plainOptions();
  EXPECT_LT(angle(HoughNormalEstimator(options).estimate(points).normal, {1, 0, 0}),
            6 * degree);
  options.plane_distance = 0.25;
  EXPECT_LT(angle(HoughNormalEstimator(options).estimate(points).normal, {0, 0, 1}),
            6 * degree);
}

TEST(HoughNormal, NoPlaneGivesNaN)
{
  HoughNormalEstimator estimator({});
  std::vector<std::vector<Eigen::Vector3f>> bad(5);
  bad[1] = {{1, 2, 3}};
  bad[2] = {{1, 2, 3}, {0, 0, 0}};
  bad[3].assign(20, {1, 2, 3});
  for (int i = 0; i < 20; ++i)
    bad[4].push_back(static_cast<float>(i) * Eigen::Vector3f(1, 2, 3));
  for (auto& points : bad) {
    const auto found = estimator.estimate(points);
    EXPECT_TRUE(std::isnan(found.normal.x())) << points.size();
    EXPECT_TRUE(std::isnan(found.curvature)) << points.size();
  }
  std::vector<Eigen::Vector3f> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_NEAR(std::abs(estimator.estimate(triangle).normal.z()), 1, 1e-6f);
}

TEST(HoughNormal, BadOptionsThrow)
{
  const auto expectBad = [](auto change) {
    HoughNormalOptions options;
    change(options);
    EXPECT_FALSE(findProblem(options).empty());
    EXPECT_THROW(HoughNormalEstimator{options}, pcl::BadArgumentException);
  };
  EXPECT_TRUE(findProblem(HoughNormalOptions{}).empty());
  expectBad([](auto& o) { o.bin_angle_degrees = 0.5; });
  expectBad([](auto& o) { o.rotations = 0; });
  expectBad([](auto& o) { o.rotations = 17; });
  expectBad([](auto& o) { o.confidence = 1; });
  expectBad([](auto& o) { o.deviation = 0; });
  expectBad([](auto& o) { o.triples = 2000000; });
  expectBad([](auto& o) { o.cubes_per_edge = 0; });
  expectBad([](auto& o) { o.plane_distance = std::nan(""); });
  expectBad([](auto& o) { o.cluster_tolerance_degrees = -1; });
  EXPECT_THROW(HoughAccumulator(0, 1, 0), pcl::BadArgumentException);
  EXPECT_THROW(HoughAccumulator(12, 0, 0), pcl::BadArgumentException);
}
