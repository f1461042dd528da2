/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

/* The histogram against all pairs of its points, by definitions of their own. */

#include <pcl/features/eppf_histogram.h>

#include <gtest/gtest.h>

#include "features/eppf_oracle.h"
#include "features/histogram_bounds.h"
#include "features/oriented_shapes.h"

#include <cmath>
#include <numeric>
#include <string>

namespace pcl::indoor {
namespace {

/** \brief Expects the histogram of many drawn pairs to be that of all pairs.
 *
 * Of uniform pairs the L1 distance is that of two histograms of drawn pairs but for a
 * square root of 2, and 0.8 of the deviations, times up to 1.2 by the weights of Eq.
 * (5.11). Stratified pairs are spread so evenly that of two million no two in a
 * thousand are missing, and noise is measured in single precision (0.0012 and 0.0033 of
 * the sum at most); a mistake in one of two hundred pairs shows.
 */
void
expectLimit(const std::vector<OrientedPoint>& points,
            EPPFOptions options,
            const std::vector<double>& of_all_pairs,
            const std::string& what)
{
  options.pair_count = 2000000;
  const auto drawn = eppfHistogram(points, options);
  const double of_chance =
      samplingBound(drawn, static_cast<double>(options.pair_count)) / std::sqrt(2.0);
  const double bound = options.sampling == PairSampling::Uniform ? of_chance : 0.005;
  const double distance = difference(drawn, of_all_pairs);
  EXPECT_LT(distance, bound) << what;
}

TEST(EPPFHistogram, EqualsTheFormulasForEveryRule)
{
  const auto points = randomSurflets(100, 1);
  for (const auto rule : {SurfaceAngleRule::Joint,
                          SurfaceAngleRule::Maximum,
                          SurfaceAngleRule::Minimum,
                          SurfaceAngleRule::Mean,
                          SurfaceAngleRule::RandomOne,
                          SurfaceAngleRule::BothInsteadOfOccupancy})
    for (const auto sides : {NormalSides::Outward,
                             NormalSides::Given,
                             NormalSides::Ignored,
                             NormalSides::MostlyOutward}) {
      auto options = pairHarmonicsOptions();
      options.bins = {4, 15, 5, 2, {3, 6, 12}};
      if (rule == SurfaceAngleRule::Mean)
        options.normal_angle_rule = NormalAngleRule::Between;
      options.denoising = false; // random points look like noise
      options.surface_angle_rule = rule;
      options.normal_sides = sides;
      expectLimit(points,
                  options,
                  slowHistogram(points, options),
                  "rule " + std::to_string(static_cast<int>(rule)) + ", sides " +
                      std::to_string(static_cast<int>(sides)));
    }
}

TEST(EPPFHistogram, EqualsTheThesis)
{
  const auto points = randomSurflets(150, 21);
  auto options = thesisEPPFOptions();
  EXPECT_EQ(options.bins.size(), 1200u);
  EXPECT_EQ(eppfHistogram(points, options), eppfHistogram(points, {})); // the defaults
  expectLimit(points, options, slowHistogram(points, options), "EPPF");
  options = shortEPPFOptions();
  EXPECT_EQ(options.bins.size(), 540u);
  expectLimit(points, options, slowHistogram(points, options), "EPPF short");
}

TEST(EPPFHistogram, EqualsTheFormulasForOtherOptions)
{
  const auto points = boxSurface({1.0f, 0.6f, 0.3f}, 150, 2);
  auto options = pairHarmonicsOptions();
  options.surface_angle_rule = SurfaceAngleRule::Maximum;
  options.bins = {7, 4, 6, 5, {2, 3, 4}};
  options.scale = 0.8;
  options.weighting_constant = 2.0;
  options.grid_size = 17;
  options.weighting = true;
  expectLimit(points, options, slowHistogram(points, options), "with weights");
  options.weighting = false;
  expectLimit(points, options, slowHistogram(points, options), "without weights");
  options.grid_size = 0; // of so many points 10
  const auto more = boxSurface({1.0f, 0.6f, 0.3f}, 400, 2);
  expectLimit(more, options, slowHistogram(more, options), "automatic grid");
}

TEST(EPPFHistogram, SwitchedOffFeatureStaysInItsFirstBin)
{
  const auto points = randomSurflets(100, 1); // objectExtent() is their diameter
  for (int off = 0; off < 5; ++off) {
    auto options = pairHarmonicsOptions();
    options.denoising = false; // random points look like noise
    options.bins = {4, 15, 5, 2, {3, 6, 12}};
    options.features = {off != 0, off != 1, off != 2, off != 3, off != 4};
    const auto histogram = eppfHistogram(points, options);
    expectLimit(points,
                options,
                slowHistogram(points, options),
                "without feature " + std::to_string(off));
    const std::size_t counts[] = {4, 15, 5, 2, 2};
    const std::size_t strides[] = {150, 10, 2, 1, 600}; // harmonics are the second half
    for (std::size_t bin = 0; bin < (off < 4 ? 600u : 1200u); ++bin)
      EXPECT_TRUE(histogram[bin] == 0.0f || (bin / strides[off]) % counts[off] == 0);
  }
}

TEST(EPPFHistogram, NoisyObjectsEqualTheFormulas)
{
  for (const auto rule : {SurfaceAngleRule::Joint, SurfaceAngleRule::Maximum})
    for (const double scale : {0.0, 0.9}) {
      const auto points = noisyBox({1.0f, 0.6f, 0.3f}, 0.07f, 400, 24);
      auto options = pairHarmonicsOptions();
      options.surface_angle_rule = rule;
      options.scale = scale;
      const auto histogram = eppfHistogram(points, options);
      expectLimit(points,
                  options,
                  slowNoisyHistogram(points, options),
                  "rule " + std::to_string(static_cast<int>(rule)));
      EXPECT_NEAR(std::accumulate(histogram.begin(), histogram.end(), 0.0), 1.0, 1e-6);
      options.denoising = false;
      EXPECT_GT(difference(histogram, eppfHistogram(points, options)), 0.1);
      for (options.number_of_threads = 1; options.number_of_threads < 4;
           ++options.number_of_threads) {
        options.denoising = true;
        EXPECT_EQ(histogram, eppfHistogram(points, options));
      }
    }
}

} // namespace
} // namespace pcl::indoor
