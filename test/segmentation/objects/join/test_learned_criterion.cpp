/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/exceptions.h>
#include <pcl/segmentation/objects/object_joining.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

using namespace pcl::indoor;

namespace {

/** A text of trees that ask for one feature. */
BoostedTrees
oneQuestion(std::size_t features, std::size_t feature, double limit)
{
  std::stringstream text;
  text << "trees " << features << " 0 1\n3\n"
       << feature << " 1 " << limit << "\n0 0 2\n0 0 -2\n";
  return BoostedTrees::read(text);
}

} // namespace

TEST(LearnedCriterion, AsksItsTrees)
{
  constexpr auto count = std::tuple_size<JoiningFeatures>::value;
  for (const std::size_t feature : {std::size_t{0}, std::size_t{17}, count - 1}) {
    LearnedCriterion criterion(oneQuestion(count, feature, 0.5));
    JoiningFeatures features{};
    EXPECT_NEAR(criterion.probability(features, 0, 1), 1 / (1 + std::exp(-2)), 1e-6);
    features[feature] = 0.6f;
    EXPECT_NEAR(criterion.probability(features, 0, 1), 1 / (1 + std::exp(2)), 1e-6);
  }
  EXPECT_THROW(LearnedCriterion(oneQuestion(count - 1, 0, 0)),
               pcl::BadArgumentException);
  EXPECT_THROW(LearnedCriterion(oneQuestion(count + 1, 0, 0)),
               pcl::BadArgumentException);
}

TEST(LearnedCriterion, BundledTreesGiveProbabilities)
{
  for (const auto scale :
       {JoiningScale::Parts, JoiningScale::Objects, JoiningScale::View}) {
    LearnedCriterion criterion(scale), same(scale);
    std::mt19937 rng(10);
    for (int trial = 0; trial < 100; ++trial) {
      JoiningFeatures features;
      for (auto& feature : features)
        feature = static_cast<float>(rng() % 4001) / 1000 - 2;
      const float probability = criterion.probability(features, 0, 1);
      EXPECT_GE(probability, 0);
      EXPECT_LE(probability, 1);
      EXPECT_EQ(probability, same.probability(features, 1, 2));
    }
  }
}
