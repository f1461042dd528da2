/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/exceptions.h>
#include <pcl/ml/histogram_distance.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace pcl::indoor {
namespace {

const HistogramDistance all_distances[] = {HistogramDistance::SymmetricKullbackLeibler,
                                           HistogramDistance::L1,
                                           HistogramDistance::L2,
                                           HistogramDistance::ChiSquared};

Histograms
randomHistograms(std::size_t count, std::size_t bins, std::uint32_t seed)
{
  std::mt19937 rng(seed);
  Histograms histograms(count, std::vector<float>(bins));
  for (auto& histogram : histograms) {
    float sum = 0.0f;
    for (auto& bin : histogram)
      sum += bin = rng() % 3 == 0 ? 0.0f : static_cast<float>(1 + rng() % 1000);
    for (auto& bin : histogram)
      bin /= std::max(sum, 1.0f);
  }
  return histograms;
}

double
slowDistance(const std::vector<float>& one,
             const std::vector<float>& two,
             double floor,
             HistogramDistance distance)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k) {
    double a = one[k];
    double b = two[k];
    const double both = a + b;
    switch (distance) {
    case HistogramDistance::SymmetricKullbackLeibler:
      a = a > 0.0 ? a : floor;
      b = b > 0.0 ? b : floor;
      sum += (a - b) * std::log(a / b);
      break;
    case HistogramDistance::L1:
      sum += std::abs(a - b);
      break;
    case HistogramDistance::L2:
      sum += (a - b) * (a - b);
      break;
    case HistogramDistance::ChiSquared:
      sum += both > 0.0 ? (a - b) * (a - b) / both : 0.0;
      break;
    }
  }
  return distance == HistogramDistance::L2 ? std::sqrt(sum) : sum;
}

TEST(HistogramDistances, EqualTheFormulas)
{
  for (const std::size_t bins : {1u, 7u, 8u, 25u, 1200u}) {
    const auto queries = randomHistograms(6, bins, 1);
    const auto gallery = randomHistograms(9, bins, 2);
    const double floor = std::min(emptyBinValue(queries), emptyBinValue(gallery));
    for (const auto distance : all_distances) {
      const auto table = histogramDistances(queries, gallery, distance);
      ASSERT_EQ(table.rows, 6u);
      ASSERT_EQ(table.columns, 9u);
      for (std::size_t row = 0; row < 6; ++row)
        for (std::size_t column = 0; column < 9; ++column) {
          const double expected =
              slowDistance(queries[row], gallery[column], floor, distance);
          // Logarithms of size up to 20, rounded to 1e-6, times bins that add up to 2.
          EXPECT_NEAR(table.at(row, column), expected, 4e-6 + 1e-5 * expected)
              << bins << " bins, distance " << static_cast<int>(distance);
        }
    }
  }
}

TEST(HistogramDistances, AreSymmetricNotNegativeAndZeroOnlyForEqualOnes)
{
  const auto histograms = randomHistograms(10, 100, 3);
  for (const auto distance : all_distances) {
    const auto table = histogramDistances(histograms, histograms, distance);
    for (std::size_t one = 0; one < 10; ++one)
      for (std::size_t two = 0; two < 10; ++two) {
        EXPECT_EQ(table.at(one, two), table.at(two, one));
        EXPECT_EQ(table.at(one, two) == 0.0f, one == two);
        EXPECT_GE(table.at(one, two), 0.0f);
      }
  }
}

TEST(HistogramDistances, ZeroBinsTakeHalfOfTheSmallestOne)
{
  // a = (1/2, 1/2, 0), b = (1/4, 1/2, 1/4): the empty bin counts 1/8, so the distance
  // is 1/4 ln 2 + 1/8 ln 2.
  const Histograms histograms = {{0.5f, 0.5f, 0.0f}, {0.25f, 0.5f, 0.25f}};
  EXPECT_FLOAT_EQ(emptyBinValue(histograms), 0.125f);
  const auto table = histogramDistances(
      histograms, histograms, HistogramDistance::SymmetricKullbackLeibler);
  EXPECT_NEAR(table.at(0, 1), 0.375 * std::log(2.0), 1e-6);
}

TEST(HistogramDistances, ThreadsChangeNothing)
{
  const auto histograms = randomHistograms(50, 300, 4);
  for (const auto distance : all_distances)
    EXPECT_EQ(histogramDistances(histograms, histograms, distance, 1).values,
              histogramDistances(histograms, histograms, distance, 3).values);
}

TEST(HistogramDistances, NothingIsNearToAHistogramThatIsNotFinite)
{
  auto histograms = randomHistograms(3, 10, 5);
  histograms[1].assign(10, std::numeric_limits<float>::quiet_NaN());
  for (const auto distance : all_distances) {
    const auto table = histogramDistances(histograms, histograms, distance);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(std::isinf(table.at(1, k)));
      EXPECT_TRUE(std::isinf(table.at(k, 1)));
    }
    EXPECT_TRUE(std::isfinite(table.at(0, 2)));
  }
}

TEST(HistogramDistances, EmptySetsAndEmptyBins)
{
  EXPECT_TRUE(histogramDistances({}, {}, HistogramDistance::L1).values.empty());
  const Histograms zeros(2, std::vector<float>(4, 0.0f));
  EXPECT_GT(emptyBinValue(zeros), 0.0f);
  for (const auto distance : all_distances)
    EXPECT_EQ(histogramDistances(zeros, zeros, distance).at(0, 1), 0.0f);
}

TEST(HistogramDistances, RefuseDifferentNumbersOfBins)
{
  EXPECT_THROW(histogramDistances({{1.0f, 0.0f}}, {{1.0f}}, HistogramDistance::L1),
               BadArgumentException);
}

} // namespace
} // namespace pcl::indoor
