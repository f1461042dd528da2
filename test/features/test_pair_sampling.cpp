/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/pair_counting.h>
#include <pcl/features/pair_sampling.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace pcl::indoor {
namespace {

std::vector<OrientedPoint>
randomPoints(std::size_t count, std::uint32_t seed)
{
  std::mt19937 rng(seed);
  std::vector<OrientedPoint> points(count);
  for (auto& point : points)
    for (int axis = 0; axis < 3; ++axis)
      point.position[axis] = static_cast<float>(rng() % 10000) / 10000.0f;
  return points;
}

class PairSampling : public testing::TestWithParam<indoor::PairSampling> {};

INSTANTIATE_TEST_SUITE_P(All,
                         PairSampling,
                         testing::Values(indoor::PairSampling::Uniform,
                                         indoor::PairSampling::Stratified));

TEST_P(PairSampling, PairsAreDifferentPointsWithinTheCloud)
{
  for (const std::size_t size : {2u, 3u, 100u}) {
    const PairSampler sampler(randomPoints(size, 1), GetParam(), 3);
    for (std::uint64_t k = 0; k < 10000; ++k) {
      const auto [one, two] = sampler.pair(k);
      ASSERT_LT(one, size);
      ASSERT_LT(two, size);
      ASSERT_NE(one, two);
    }
  }
}

TEST_P(PairSampling, AllPairsAreEquallyLikely)
{
  // 20 x 19 ordered pairs, 380,000 draws: 1,000 each, standard deviation 31.6 if the
  // draws are independent. Six deviations are passed by chance once in 10^6 runs of 380
  // counts.
  const PairSampler sampler(randomPoints(20, 2), GetParam(), 4);
  std::vector<int> counts(400);
  for (std::uint64_t k = 0; k < 380000; ++k) {
    const auto [one, two] = sampler.pair(k);
    ++counts[20 * one + two];
  }
  for (int one = 0; one < 20; ++one)
    for (int two = 0; two < 20; ++two)
      EXPECT_NEAR(counts[20 * one + two], one == two ? 0 : 1000, 190)
          << one << ", " << two;
}

TEST_P(PairSampling, SeedDecides)
{
  const auto points = randomPoints(1000, 5);
  const PairSampler sampler(points, GetParam(), 6);
  const PairSampler same(points, GetParam(), 6);
  const PairSampler other(points, GetParam(), 7);
  int equal = 0;
  for (std::uint64_t k = 0; k < 1000; ++k) {
    EXPECT_EQ(sampler.pair(k), same.pair(k));
    equal += sampler.pair(k) == other.pair(k) ? 1 : 0;
  }
  EXPECT_LT(equal, 5); // by chance one pair in 999,000 agrees
}

TEST(PairSampler, StratifiedPairsAreSpreadMoreEvenly)
{
  // How often the pairs of two halves of the curve occur: 5,000 of 20,000 each.
  const auto points = randomPoints(1000, 8);
  const auto error = [&](indoor::PairSampling sampling) {
    double sum = 0.0;
    for (std::uint32_t seed = 0; seed < 50; ++seed) {
      const PairSampler sampler(points, sampling, seed);
      int low_high = 0;
      for (std::uint64_t k = 0; k < 20000; ++k) {
        const auto [one, two] = sampler.pair(k);
        // The first bit of the curve is the half along x.
        low_high += points[one].position.x() < 0.5f && points[two].position.x() >= 0.5f;
      }
      const double low = static_cast<double>(
          std::count_if(points.begin(), points.end(), [](const auto& p) {
            return p.position.x() < 0.5f;
          }));
      const double expected = 20000.0 * low * (1000.0 - low) / (1000.0 * 999.0);
      sum += std::abs(low_high - expected);
    }
    return sum / 50;
  };
  // Independent draws: sqrt(20000 * 3 / 16) * sqrt(2 / pi) = 49 pairs on average.
  EXPECT_GT(error(indoor::PairSampling::Uniform), 30.0);
  EXPECT_LT(error(indoor::PairSampling::Stratified), 10.0);
}

TEST(PairSampler, StratifiedPairsDoNotDependOnTheOrderOfThePoints)
{
  const auto points = randomPoints(500, 9);
  std::vector<OrientedPoint> reversed(points.rbegin(), points.rend());
  const PairSampler sampler(points, indoor::PairSampling::Stratified, 1);
  const PairSampler turned(reversed, indoor::PairSampling::Stratified, 1);
  for (std::uint64_t k = 0; k < 1000; ++k) {
    const auto [one, two] = sampler.pair(k);
    const auto [three, four] = turned.pair(k);
    EXPECT_EQ(points[one].position, reversed[three].position);
    EXPECT_EQ(points[two].position, reversed[four].position);
  }
}

TEST(CountBlocks, EachBlockCountsOnceOnAnyNumberOfThreads)
{
  const auto count = [](std::size_t block, std::vector<std::uint64_t>& own) {
    own[block % 7] += block + 1;
  };
  for (const std::size_t blocks : {0u, 1u, 3u, 100u}) {
    std::vector<std::uint64_t> expected(7);
    for (std::size_t block = 0; block < blocks; ++block)
      count(block, expected);
    for (const unsigned int threads : {1u, 2u, 5u, 0u})
      EXPECT_EQ(countBlocks(blocks, 7, threads, count), expected)
          << blocks << " blocks, " << threads << " threads";
  }
}

TEST(CountPairs, LastBlockEndsWithThePairs)
{
  for (const std::size_t pairs : {1u, 511u, 512u, 513u, 5000u}) {
    const auto counts =
        countPairs(pairs, 5000, 2, [](std::size_t first, std::size_t last, auto& own) {
          for (std::size_t k = first; k < last; ++k)
            ++own[k];
        });
    EXPECT_EQ(std::count(counts.begin(), counts.end(), 1u),
              static_cast<std::ptrdiff_t>(pairs));
    EXPECT_EQ(std::count(counts.begin(), counts.end(), 0u),
              static_cast<std::ptrdiff_t>(5000 - pairs));
  }
}

TEST(SpaceFillingOrder, HoldsAllPointsWhateverTheirCoordinates)
{
  for (const float size : {1e-42f, 1e-30f, 1e20f, 3e38f}) {
    std::vector<OrientedPoint> points(64);
    std::mt19937 rng(5);
    for (auto& point : points)
      for (int axis = 0; axis < 3; ++axis)
        point.position[axis] =
            size * (static_cast<float>(rng() % 2001) / 1000.0f - 1.0f);
    auto order = spaceFillingOrder(points);
    std::sort(order.begin(), order.end());
    for (std::uint32_t k = 0; k < order.size(); ++k)
      EXPECT_EQ(order[k], k) << size;
  }
}

} // namespace
} // namespace pcl::indoor
