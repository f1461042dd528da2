/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/exceptions.h>
#include <pcl/features/eppf_histogram.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include "features/histogram_bounds.h"
#include "features/oriented_shapes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace pcl::indoor {
namespace {

// A value within rounding of a border may fall on either side of it: of 20,000 pairs
// with features in single precision (relative error 1e-7) a handful at most, each 1 /
// 20,000 of the sum on two sides and up to 0.79 / 0.18 of it by the weights.
constexpr double border_share = 10 * 2 * 4.4 / 20000;

TEST(EPPFHistogram, SidesOfNormalsDoNotMatterUnlessGiven)
{
  const auto points = boxSurface({1.0f, 0.6f, 0.3f}, 1000, 22);
  auto turned = points;
  for (std::size_t k = 0; k < turned.size(); k += 3)
    turned[k].normal = -turned[k].normal;
  auto options = pairHarmonicsOptions();
  options.normal_angle_rule = NormalAngleRule::Between;
  for (const auto sides : {NormalSides::Outward, NormalSides::Ignored}) {
    options.normal_sides = sides;
    EXPECT_EQ(eppfHistogram(points, options), eppfHistogram(turned, options));
  }
  for (const auto sides : {NormalSides::Given, NormalSides::MostlyOutward}) {
    options.normal_sides = sides;
    EXPECT_GT(
        difference(eppfHistogram(points, options), eppfHistogram(turned, options)),
        0.1);
  }
  // All turned over together: which side is outside does not matter.
  for (std::size_t k = 0; k < points.size(); ++k)
    turned[k].normal = -points[k].normal;
  options.normal_sides = NormalSides::MostlyOutward;
  EXPECT_EQ(eppfHistogram(points, options), eppfHistogram(turned, options));
}

TEST(EPPFHistogram, TurnAboutTheLineInClosedForm)
{
  // Two points and normals of 60 and 120 degrees to the line between them, one turned
  // about it by an angle: f3 is that angle, whatever the other two are.
  EPPFOptions options;
  options.bins = {1, 1, 5, 1, {}};
  options.normal_angle_rule = NormalAngleRule::AroundLine;
  options.normal_sides = NormalSides::MostlyOutward;
  const Eigen::Vector3f line = Eigen::Vector3f(1.0f, 2.0f, -1.0f).normalized();
  const Eigen::Vector3f across = line.unitOrthogonal();
  const float half = 0.5f, rest = std::sqrt(0.75f);
  for (int bin = 0; bin < 5; ++bin)
    for (const float side : {-1.0f, 1.0f}) {
      const float angle = side * (static_cast<float>(bin) + 0.4f) * 0.628318531f;
      const Eigen::Vector3f turned = Eigen::AngleAxisf(angle, line) * across;
      const std::vector<OrientedPoint> two = {
          {Eigen::Vector3f::Zero(), -half * line + rest * across},
          {3.0f * line, half * line + rest * turned}};
      EXPECT_FLOAT_EQ(eppfHistogram(two, options)[bin], 1.0f);
    }
  // Normals along the line have no turn.
  const std::vector<OrientedPoint> along = {{Eigen::Vector3f::Zero(), -line},
                                            {line, line}};
  EXPECT_FLOAT_EQ(eppfHistogram(along, options)[0], 1.0f);
}

TEST(EPPFHistogram, SumIsOneAndSeedsDiffer)
{
  const auto points = boxSurface({1.0f, 0.6f, 0.3f}, 2000, 4);
  auto options = pairHarmonicsOptions();
  const auto histogram = eppfHistogram(points, options);
  EXPECT_EQ(histogram.size(), 1200u);
  EXPECT_NEAR(
      std::accumulate(histogram.begin(), histogram.begin() + 600, 0.0), 0.5, 1e-6);
  // 1,200 roundings to single precision of values that add up to 1.
  EXPECT_NEAR(std::accumulate(histogram.begin(), histogram.end(), 0.0), 1.0, 1e-6);
  EXPECT_EQ(histogram, eppfHistogram(points, options));
  options.seed = 77;
  EXPECT_NE(histogram, eppfHistogram(points, options));
}

TEST(EPPFHistogram, ThreadsChangeNoBit)
{
  const auto points = boxSurface({1.0f, 0.6f, 0.3f}, 2000, 5);
  auto options = pairHarmonicsOptions();
  const auto histogram = eppfHistogram(points, options);
  for (const unsigned int threads : {2u, 3u, 8u, 0u}) {
    options.number_of_threads = threads;
    EXPECT_EQ(histogram, eppfHistogram(points, options)) << threads << " threads";
  }
}

TEST(EPPFHistogram, OrderOfThePointsChangesOnlySampling)
{
  auto points = boxSurface({1.0f, 0.6f, 0.3f}, 2000, 6);
  auto options = pairHarmonicsOptions();
  options.weighting = false;
  options.sampling = PairSampling::Uniform;
  const auto histogram = eppfHistogram(points, options);
  std::mt19937 rng(6);
  for (std::size_t k = points.size() - 1; k > 0; --k)
    std::swap(points[k], points[rng() % (k + 1)]);
  const double distance = difference(histogram, eppfHistogram(points, options));
  EXPECT_GT(distance, 0.0);
  EXPECT_LT(distance, samplingBound(histogram, 20000));
  options.sampling = PairSampling::Stratified;
  const auto stratified = eppfHistogram(points, options);
  std::reverse(points.begin(), points.end());
  EXPECT_EQ(stratified, eppfHistogram(points, options));
}

TEST(EPPFHistogram, TurningChangesOnlyRoundingBesidesOccupancy)
{
  const auto points = randomSurflets(1000, 7);
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(1.1f, Eigen::Vector3f(1.0f, 2.0f, 3.0f).normalized())
          .toRotationMatrix();
  auto turned = points;
  for (auto& point : turned) {
    point.position = turn * point.position + Eigen::Vector3f(3.0f, -2.0f, 1.0f);
    point.normal = turn * point.normal;
  }
  auto options = pairHarmonicsOptions();
  options.denoising = false;                // random points look like noise
  options.sampling = PairSampling::Uniform; // draws the same pairs of both
  options.features.occupancy = false;
  // Positions of size 4 are rounded to 2.4e-7, features by about as much: the pairs
  // within that of a border are again a handful.
  EXPECT_LT(difference(eppfHistogram(points, options), eppfHistogram(turned, options)),
            border_share);
}

TEST(EPPFHistogram, TurningChangesOnlySamplingOfStratifiedPairs)
{
  // The space-filling order turns with the axes, so that other pairs are drawn; the
  // bound of independent draws holds for both.
  const auto points = boxSurface({1.0f, 0.6f, 0.3f}, 2000, 23);
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(0.6f, Eigen::Vector3f(1.0f, 2.0f, 3.0f).normalized())
          .toRotationMatrix();
  auto turned = points;
  for (auto& point : turned) {
    point.position = turn * point.position;
    point.normal = turn * point.normal;
  }
  auto options = pairHarmonicsOptions();
  options.features.occupancy = false; // its grid turns with the axes, too
  options.weighting = false;
  const auto histogram = eppfHistogram(points, options);
  const double distance = difference(histogram, eppfHistogram(turned, options));
  EXPECT_GT(distance, 0.0);
  EXPECT_LT(distance, samplingBound(histogram, 20000));
}

TEST(EPPFHistogram, ScaleFreeWithTheObjectsOwnExtent)
{
  auto points = randomSurflets(1000, 8);
  const auto histogram = eppfHistogram(points, pairHarmonicsOptions());
  for (auto& point : points)
    point.position *= 4.0f; // a power of two: no rounding at all
  EXPECT_EQ(histogram, eppfHistogram(points, pairHarmonicsOptions()));
  auto options = pairHarmonicsOptions();
  options.scale = 10.0;
  EXPECT_GT(difference(histogram, eppfHistogram(points, options)), 0.5);
}

TEST(EPPFHistogram, ObjectsWithoutNoiseAreLeftAsTheyAre)
{
  const auto points = boxSurface({1.0f, 0.6f, 0.3f}, 2000, 25);
  auto options = pairHarmonicsOptions();
  options.denoising = false;
  EXPECT_EQ(eppfHistogram(points, pairHarmonicsOptions()),
            eppfHistogram(points, options));
}

TEST(EPPFHistogram, DegenerateObjectsGiveADefinedResult)
{
  for (const std::size_t count : {0u, 1u}) {
    const auto histogram =
        eppfHistogram(std::vector<OrientedPoint>(count), pairHarmonicsOptions());
    ASSERT_EQ(histogram.size(), 1200u);
    for (const float value : histogram)
      EXPECT_TRUE(std::isnan(value));
  }
  std::vector<OrientedPoint> same(5);
  for (auto& point : same)
    point = {{1.0f, 2.0f, 3.0f}, {0.0f, 0.0f, 1.0f}};
  EXPECT_TRUE(std::isnan(eppfHistogram(same, pairHarmonicsOptions()).front()));
  // Two points: one distance, the longest; both normals along it; all in one bin.
  // Beside them two points at the ends of the longest axis, 2.5 shells from its middle:
  // in the middle of the third shell, and facing along the axis.
  std::vector<OrientedPoint> two = {same[0], same[1]};
  two[1].position.z() = 4.0f;
  const auto histogram = eppfHistogram(two, pairHarmonicsOptions());
  const auto harmonics = histogram.begin() + 600;
  EXPECT_NEAR(*std::max_element(histogram.begin(), harmonics), 0.5, 1e-6);
  EXPECT_NEAR(std::accumulate(harmonics, histogram.end(), 0.0), 0.5, 1e-6);
  EXPECT_NEAR(harmonics[4 * 49], harmonics[8 * 49] * 0.002 / 1.002, 1e-6);
  EXPECT_NEAR(harmonics[8 * 49], harmonics[11 * 49], 1e-6);
  EXPECT_NEAR(harmonics[9 * 49], harmonics[4 * 49], 1e-6);
  // A flat object: surface angles and normal angles all 0.
  auto flat = boxSurface({1.0f, 1.0f, 0.0f}, 500, 9);
  for (auto& point : flat)
    point.normal = {0.0f, 0.0f, 1.0f};
  const auto plane = eppfHistogram(flat, thesisEPPFOptions());
  EXPECT_NEAR(std::accumulate(plane.begin(), plane.end(), 0.0), 1.0, 1e-6);
  for (std::size_t bin = 0; bin < plane.size(); ++bin)
    EXPECT_TRUE(plane[bin] == 0.0f || bin % 15 < 3); // f3 = 0
}

TEST(EPPFHistogram, OnePairOfManyInOnePlaceIsFound)
{
  // Pairs of the 999 points in one place have no direction and are left out. One pair
  // in 500 is left; with a single pair drawn there may be none: NaN then, never 0 / 0
  // bins.
  std::vector<OrientedPoint> points(1000);
  for (auto& point : points)
    point.normal = {0.0f, 0.0f, 1.0f};
  points.back().position = {1.0f, 0.0f, 0.0f};
  const auto histogram = eppfHistogram(points, pairHarmonicsOptions());
  EXPECT_NEAR(std::accumulate(histogram.begin(), histogram.end(), 0.0), 1.0, 1e-6);
  auto options = pairHarmonicsOptions();
  options.pair_count = 1;
  for (options.seed = 0; options.seed < 20; ++options.seed) {
    const auto few = eppfHistogram(points, options);
    const double sum = std::accumulate(few.begin(), few.end(), 0.0);
    EXPECT_TRUE(std::isnan(sum) || std::abs(sum - 1.0) < 1e-6);
  }
}

TEST(EPPFHistogram, RefusesEveryParameterOutOfRange)
{
  const auto points = randomSurflets(10, 10);
  const auto refuses = [&](auto change) {
    auto options = pairHarmonicsOptions();
    change(options);
    EXPECT_THROW(eppfHistogram(points, options), BadArgumentException);
    EXPECT_FALSE(findProblem(options).empty());
  };
  refuses([](auto& o) { o.bins.surface_angle = 4; }); // not L (L + 1) / 2
  refuses([](auto& o) { o.bins.distance = 0; });
  refuses([](auto& o) { o.bins.surface_angle = -1; });
  refuses([](auto& o) { o.bins.normal_angle = 65; });
  refuses([](auto& o) { o.bins.occupancy = 0; });
  refuses([](auto& o) { o.bins.harmonics = {3, -1, 4}; });
  refuses([](auto& o) { o.bins.harmonics = {3, 9, 4}; });
  refuses([](auto& o) { o.bins.harmonics = {-1, 6, 4}; });
  refuses([](auto& o) { o.bins.harmonics = {3, 6, 65}; });
  refuses([](auto& o) { o.pair_count = 0; });
  refuses([](auto& o) { o.scale = -1.0; });
  refuses([](auto& o) { o.scale = std::nan(""); });
  refuses([](auto& o) { o.weighting_constant = 1.0; });
  refuses([](auto& o) { o.weighting_constant = std::nan(""); });
  refuses([](auto& o) { o.grid_size = 1; });
  refuses([](auto& o) { o.grid_size = 65; });
  for (const auto& options :
       {EPPFOptions(), shortEPPFOptions(), pairHarmonicsOptions()})
    EXPECT_TRUE(findProblem(options).empty());
}

} // namespace
} // namespace pcl::indoor
