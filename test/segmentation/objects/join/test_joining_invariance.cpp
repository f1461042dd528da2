/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "segmentation/objects/join/piece_pair.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

void
expectFinite(const JoiningFeatures& features)
{
  for (std::size_t i = 0; i < features.size(); ++i)
    EXPECT_TRUE(std::isfinite(features[i])) << joiningFeatureNames()[i];
}

/** Two pieces of random places on two leaning plates with a contact between them. */
PiecePair
randomPair(std::mt19937& rng, const Eigen::Vector3f& shift, const Eigen::Matrix3f& turn)
{
  const auto random = [&] { return static_cast<float>(rng() % 2001) / 1000 - 1; };
  PiecePair pair;
  for (auto* piece : {&pair.a, &pair.b}) {
    const float slope = random(), side = random();
    const Eigen::Vector3f size(random(), random(), random());
    const Eigen::Vector3f normal = Eigen::Vector3f(-slope, side, 1).normalized();
    Places places, normals;
    const auto count = 20 + rng() % 40;
    for (unsigned i = 0; i < count; ++i) {
      const float x = random(), y = random(), z = random();
      places.push_back(turn * Eigen::Vector3f(x, y, slope * x - side * y + 0.1f * z)
                                  .cwiseProduct(size.cwiseAbs()) +
                       shift);
      normals.push_back(turn * (normal + 0.1f * size).normalized());
    }
    *piece = pieceOf(places, normals, 3);
    piece->parts = 1 + rng() % 4;
  }
  auto& contact = pair.contact;
  contact.first_voxels = 7;
  contact.second_voxels = 9;
  for (int i = 0; i < 12; ++i) {
    const float x = random(), y = random(), z = random();
    contact.places.add((turn * Eigen::Vector3f(x, y, z) + shift).cast<double>());
  }
  contact.bends = 5;
  contact.bend_sum = 60;
  contact.bend_squares = 900;
  contact.concave_bends = 3;
  contact.gap = 0.04;
  contact.near_cells = 6;
  contact.near_in_line = 2;
  pair.floor = -1 + shift.z();
  pair.touching_a = 11;
  pair.touching_b = 13;
  pair.contacts_b = 4;
  return pair;
}

} // namespace

TEST(JoiningInvariance, DoNotDependOnWhereTheRoomIs)
{
  const Eigen::Matrix3f still = Eigen::Matrix3f::Identity();
  Eigen::Matrix3f quarter = Eigen::Matrix3f::Identity();
  quarter.topLeftCorner<2, 2>() << 0, -1, 1, 0;
  for (unsigned trial = 0; trial < 20; ++trial) {
    std::mt19937 rng(trial), same(trial), again(trial);
    const auto here = randomPair(rng, {0, 0, 0}, still).features();
    const auto there = randomPair(same, {12, -7, 3}, still).features();
    const auto turned = randomPair(again, {0, 0, 0}, quarter).features();
    expectFinite(here);
    for (std::size_t i = 0; i < here.size(); ++i) {
      const auto tolerance = 1e-3f * (1 + std::abs(here[i]));
      EXPECT_NEAR(here[i], there[i], tolerance) << joiningFeatureNames()[i];
      EXPECT_NEAR(here[i], turned[i], tolerance) << joiningFeatureNames()[i];
    }
  }
}

TEST(JoiningInvariance, BothSidesAreMeasuredAlike)
{
  std::mt19937 rng(4);
  for (unsigned trial = 0; trial < 20; ++trial) {
    const auto pair = randomPair(rng, {0, 0, 0}, Eigen::Matrix3f::Identity());
    auto swapped = pair;
    std::swap(swapped.a, swapped.b);
    std::swap(swapped.touching_a, swapped.touching_b);
    std::swap(swapped.contacts_a, swapped.contacts_b);
    std::swap(swapped.contact.first_voxels, swapped.contact.second_voxels);
    const auto one = pair.features(), other = swapped.features();
    for (std::size_t i = 0; i < one.size(); ++i) {
      const std::string name = joiningFeatureNames()[i];
      const bool of_a = name.size() > 3 && name.substr(name.size() - 3) == ", a";
      const bool of_b = name.size() > 3 && name.substr(name.size() - 3) == ", b";
      const auto stem = name.substr(0, name.size() - 1);
      if (name == "box of a within b")
        continue;
      double expected = other[i];
      if (name == "low, b - a" || name == "high, b - a")
        expected = -expected;
      else if (of_a || of_b)
        expected = other[indexOf(stem + (of_a ? "b" : "a"))];
      else if (name == "b over the plane of a")
        expected = other[indexOf("a over the plane of b")];
      else if (name == "a over the plane of b")
        expected = other[indexOf("b over the plane of a")];
      EXPECT_NEAR(one[i], expected, 1e-5 * (1 + std::abs(expected))) << name;
    }
  }
}

TEST(JoiningInvariance, AreFiniteForTheSmallestPieces)
{
  const Eigen::Vector3f up(0, 0, 1), none(0, 0, 0);
  std::vector<Piece> pieces;
  for (const auto& normal : {up, none})
    for (const float margin : {0.0f, 0.015f}) {
      pieces.push_back(pieceOf({{1, 2, 3}}, {normal}, 1, margin));
      pieces.push_back(pieceOf({{1, 2, 3}, {1.03f, 2, 3}}, {normal}, 1, margin));
      pieces.push_back(
          pieceOf({{1, 2, 3}, {1, 2.03f, 3}, {1, 2, 3.03f}}, {normal}, 1, margin));
      pieces.push_back(pieceOf({{-100, 40, 3}}, {normal}, 1, margin));
    }
  PieceContact touching;
  touching.first_voxels = 1;
  touching.second_voxels = 1;
  touching.places.add({1, 2, 3});
  for (const auto& a : pieces)
    for (const auto& b : pieces)
      for (const auto& contact : {PieceContact(), touching}) {
        const auto features = PiecePair{a, b, contact}.features();
        expectFinite(features);
        EXPECT_GE(features[indexOf("air over smaller")], -2);
        EXPECT_LE(features[indexOf("air over smaller")], 20);
        EXPECT_LE(features[indexOf("air of boxes")], 20);
      }
}
