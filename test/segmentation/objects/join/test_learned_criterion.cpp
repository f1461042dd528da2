/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "objects/join/object_joining.h"
#include "segmentation/objects/join/piece_pair.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

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

TEST(LearnedCriterion, BundledTreesTellHalvesOfATableTopFromTwoObjects)
{
  const float voxel = static_cast<float>(pair_voxel_size);
  const auto plate = [voxel](float x, float y, float z) { // 60 x 80 cm
    Places places;
    for (float u = x; u < x + 0.6f - voxel / 2; u += voxel)
      for (float v = y; v < y + 0.8f; v += voxel)
        places.emplace_back(u, v, z);
    return places;
  };
  const Places up{{0, 0, 1}};
  Places seen = plate(0, 0, 0);
  for (const float x : {-0.6f, 0.6f, 1.2f})
    for (const auto& place : plate(x, 0, 0))
      seen.push_back(place);
  const auto pairOf = [&](const Places& a, const Places& b) {
    PiecePair pair;
    pair.a = pieceOf(a, up, 1, voxel / 2);
    pair.b = pieceOf(b, up, 1, voxel / 2);
    auto all = seen; // floor all around
    all.insert(all.end(), a.begin(), a.end());
    all.insert(all.end(), b.begin(), b.end());
    pair.columns = {all, 0, pair_voxel_size};
    pair.contact.near_cells = 20;
    return pair;
  };
  auto halves = pairOf(plate(0, 0, 0.72f), plate(0.6f, 0, 0.72f));
  auto& contact = halves.contact;
  contact.first_voxels = contact.second_voxels = 27;
  halves.touching_a = halves.touching_b = 27;
  for (float v = 0; v < 0.8f; v += voxel)
    contact.places.add({0.6, v, 0.72}, 3);
  contact.bends = 20;
  contact.bend_sum = -20;
  contact.bend_squares = 40;
  contact.gap = contact.near_cells > 0 ? 3 * pair_voxel_size : 0;
  contact.near_in_line = 20;
  auto apart = pairOf(plate(0, 0, 0.72f), plate(0.72f, 0.3f, 0.4f));
  apart.contact.gap = 0.17;
  for (const auto scale :
       {JoiningScale::Parts, JoiningScale::Objects, JoiningScale::View}) {
    LearnedCriterion criterion(scale);
    EXPECT_GT(criterion.probability(halves.features(), 0, 1),
              criterion.probability(apart.features(), 0, 1) + 0.3f)
        << static_cast<int>(scale);
  }
}
