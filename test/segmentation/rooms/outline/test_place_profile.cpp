/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/outline/place_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace pcl::indoor;

namespace {

/** Normal noise around a place. */
void
addFace(std::vector<double>& places, double at, int count, double noise, unsigned seed)
{
  std::mt19937 rng(seed);
  std::normal_distribution<double> place(at, noise);
  for (int i = 0; i < count; ++i)
    places.push_back(place(rng));
}

std::optional<double>
firstFace(const std::vector<double>& places, std::uint32_t least = 1)
{
  PlaceProfile profile(0.0, 3.0, 0.04);
  for (const double place : places)
    profile.add(place);
  return profile.firstFace(least);
}

} // namespace

TEST(PlaceProfile, TheFirstOfTwoFacesIsFoundAndOutliersAreNone)
{
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::vector<double> places;
    const double at = 1.0 + 0.013 * seed;
    addFace(places, at, 300, 0.012, seed);
    addFace(places, at + 0.3, 400, 0.012, seed + 100);
    addFace(places, at + 0.8, 100, 0.012, seed + 200);
    addFace(places, at - 0.3, 60, 0.02, seed + 300); // fewer than half as many
    addFace(places, 0.5, 20, 0.5, seed + 400);
    const auto face = firstFace(places);
    ASSERT_TRUE(face);
    EXPECT_NEAR(*face, at, 0.004);
    std::reverse(places.begin(), places.end());
    EXPECT_EQ(firstFace(places), face);
  }
}

TEST(PlaceProfile, AFaceOfHalfAsManyPointsCountsAndOneOfFewerDoesNot)
{
  std::vector<double> places(100, 2.0);
  places.insert(places.end(), 50, 1.0);
  EXPECT_NEAR(*firstFace(places), 1.0, 0.001);
  places.pop_back();
  EXPECT_NEAR(*firstFace(places), 2.0, 0.001);
}

TEST(PlaceProfile, TooFewPointsAndPointsOutsideAreNoFace)
{
  EXPECT_FALSE(firstFace({}));
  EXPECT_FALSE(firstFace({-0.1, 9.0}));
  EXPECT_FALSE(firstFace({1.0, 1.01}, 3));
  EXPECT_NEAR(*firstFace({1.0, 1.01}, 2), 1.005, 0.001);
  EXPECT_NEAR(*firstFace({1.0}), 1.0, 0.001);
  EXPECT_NEAR(*firstFace({0.0}), 0.0, 0.001);
  EXPECT_NEAR(*firstFace({2.999}), 2.999, 0.001);
}
