/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "segmentation/objects/join/piece_pair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

/** The corners of a box, 100 voxels each; its normals are those of its six faces. */
Piece
box(const Eigen::Vector3f& low, const Eigen::Vector3f& high)
{
  Places corners, normals;
  for (const float x : {low.x(), high.x()})
    for (const float y : {low.y(), high.y()})
      for (const float z : {low.z(), high.z()})
        corners.emplace_back(x, y, z);
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {-1.0f, 1.0f})
      normals.push_back(sign * Eigen::Vector3f::Unit(axis));
  return pieceOf(corners, normals, 100);
}

/** A level plate, its normals up. */
Piece
plate(const Eigen::Vector3f& low, float x, float y, float sign = 1)
{
  auto piece = box(low, low + Eigen::Vector3f(x, y, 0));
  const auto count = piece.positions.count;
  piece.normals = {};
  piece.normals.add({0, 0, sign}, count);
  return piece;
}

void
expectFeatures(const JoiningFeatures& features,
               const std::vector<std::pair<const char*, double>>& expected,
               double tolerance = 1e-4)
{
  for (const auto& [name, value] : expected)
    EXPECT_NEAR(features[indexOf(name)], value, tolerance) << name;
}

} // namespace

TEST(JoiningFeatures, HaveNamesOfTheirOwn)
{
  const auto& names = joiningFeatureNames();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(),
            std::tuple_size<JoiningFeatures>::value);
}

TEST(JoiningFeatures, ABoxIsDescribedByItsSizes)
{
  PiecePair pair{box({1, 2, 0.5f}, {2, 2.5f, 0.9f}), box({2, 2, 0.5f}, {3, 3, 1})};
  pair.floor = 0.25;
  pair.a.parts = 3;
  expectFeatures(pair.features(),
                 {{"log area, a", std::log(800 * 0.0009)},
                  {"height, a", 0.4},
                  {"low, a", 0.25},
                  {"high, a", 0.65},
                  {"thickness, a", 0.2}, // half the edges, of the corners
                  {"middle, a", 0.25},
                  {"length, a", 0.5},
                  {"level, a", 1.0 / 3},
                  {"one-sided, a", 0},
                  {"second direction, a", 1.0 / 3},
                  {"main direction, a", 1.0 / 3},
                  {"log outline, a", std::log(0.5)},
                  {"log volume, a", std::log(0.2)},
                  {"height, b", 0.5},
                  {"low, b", 0.25},
                  {"high, b", 0.75},
                  {"length, b", 0.5},
                  {"thickness, b", 0.25},
                  {"log outline, b", 0},
                  {"log volume, b", std::log(0.5)},
                  {"log parts, a", std::log(3)},
                  {"log parts, b", 0},
                  {"voxel size", 0.03}});
}

TEST(JoiningFeatures, APlateIsThin)
{
  const PiecePair pair{plate({0, 0, 0.7f}, 1, 0.5f), plate({2, 0, 0.7f}, 1, 1, -1)};
  expectFeatures(pair.features(),
                 {{"height, a", 0},
                  {"low, a", 0.7},
                  {"thickness, a", 0},
                  {"middle, a", 0.25},
                  {"length, a", 0.5},
                  {"level, a", 1},
                  {"one-sided, a", 1},
                  {"second direction, a", 0},
                  {"main direction, a", 1},
                  {"log outline, a", std::log(0.5)},
                  {"log volume, a", std::log(std::pow(pair_voxel_size, 3))},
                  {"main direction, b", 1},
                  {"one-sided, b", 1},
                  {"cosine of normals", -1},
                  {"b over the plane of a", 0},
                  {"thickness of both", 0}});
}

TEST(JoiningFeatures, PlatesAboveEachOtherAreOutOfPlane)
{
  const PiecePair pair{plate({0, 0, 0.1f}, 1, 0.5f), plate({0, 0, 0.4f}, 1, 0.5f)};
  expectFeatures(pair.features(),
                 {{"b over the plane of a", 0.3 / 0.03},
                  {"a over the plane of b", 0.3 / 0.03},
                  {"cosine of normals", 1},
                  {"thickness of both", 0.15},
                  {"middle of both", 0.25},
                  {"log hull", std::log(0.15)},
                  {"air over hull", 1},
                  {"air over smaller", 20}, // the most
                  {"air of boxes", 20},
                  {"outline of smaller within", 1},
                  {"outline in common", 1},
                  {"heights in common", -0.3 / 0.03},
                  {"low, b - a", 0.3},
                  {"high, b - a", 0.3}},
                 1e-3);
}

TEST(JoiningFeatures, AirIsBetweenBoxesSideBySide)
{
  const PiecePair pair{box({0, 0, 0}, {1, 0.5f, 0.4f}),
                       box({1.5f, 0, 0}, {3.5f, 0.5f, 0.4f})};
  expectFeatures(pair.features(),
                 {{"air over smaller", 0.1 / 0.2},
                  {"air over hull", 0.1 / 0.7},
                  {"air of boxes", 0.1 / 0.2},
                  {"log hull", std::log(0.7)},
                  {"surface over hull", 1600 * 0.0009 / std::pow(0.7, 2.0 / 3)},
                  {"box of a within b", 0},
                  {"outline of smaller within", 0},
                  {"outline in common", 0},
                  {"log outline of both", std::log(3.5 * 0.5)},
                  {"heights in common", 1},
                  {"low, b - a", 0},
                  {"high, b - a", 0}});
  // Their corners' deviations about the common middle
  expectFeatures(pair.features(),
                 {{"thickness of both", 0.2}, {"middle of both", 0.25}});
}

TEST(JoiningFeatures, BoxesWithinEachOtherHaveLessThanNoAir)
{
  const PiecePair pair{box({0.25f, 0, 0}, {0.75f, 0.5f, 0.5f}),
                       box({0, 0, 0}, {1, 0.5f, 0.5f})};
  expectFeatures(pair.features(),
                 {{"air over smaller", -1},
                  {"air over hull", -0.5},
                  {"air of boxes", 0},
                  {"box of a within b", 1},
                  {"outline of smaller within", 1},
                  {"outline in common", 0.5}});
  const PiecePair across{box({0, 0, 0}, {1, 0.5f, 0.5f}),
                         box({0.75f, 0, 0.25f}, {1.75f, 0.5f, 0.75f})};
  expectFeatures(
      across.features(),
      {{"box of a within b", 0.25 * 0.5},
       {"air of boxes", (1.75 * 0.5 * 0.75 - 2 * 0.25 + 0.25 * 0.5 * 0.25) / 0.25},
       {"outline of smaller within", 0.25},
       {"outline in common", 0.25 / 1.75},
       {"heights in common", 0.5},
       {"low, b - a", 0.25},
       {"high, b - a", 0.25}});
}

TEST(JoiningFeatures, OutlinesAreCutAtTheirCorners)
{
  // Two squares that meet in a corner: their hull is a hexagon.
  const PiecePair pair{box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})};
  expectFeatures(pair.features(), {{"log outline of both", std::log(3)}});
  // An octagon around the unit circle, and a triangle that is half of a square.
  Places octagon;
  const float corner = std::tan(static_cast<float>(M_PI) / 8);
  for (const float u : {-1.0f, 1.0f})
    for (const float v : {-corner, corner}) {
      octagon.emplace_back(u, v, 0);
      octagon.emplace_back(v, u, 1);
    }
  const PiecePair others{pieceOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}}),
                         pieceOf(octagon, {{0, 0, 1}})};
  expectFeatures(others.features(),
                 {{"log outline, a", std::log(0.5)},
                  {"log outline, b", std::log(8 * corner)},
                  {"outline of smaller within", 1}});
}

TEST(JoiningFeatures, ContactsAreMeasuredByVoxelsAndPlaces)
{
  PiecePair pair{box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 2})};
  pair.floor = -1;
  pair.contact.first_voxels = 20;
  pair.contact.second_voxels = 40;
  pair.touching_a = 80;
  pair.touching_b = 40;
  pair.contacts_a = 5;
  for (const double z : {0.0, 1.0})
    for (const double y : {0.4, 0.6})
      pair.contact.places.add({1, y, z});
  expectFeatures(pair.features(),
                 {{"touching share, a", 20.0 / 800},
                  {"touching length, a", 20 / std::sqrt(800)},
                  {"share of touching, a", 0.25},
                  {"height of contact, a", 0.5},
                  {"touching share, b", 40.0 / 800},
                  {"touching length, b", 40 / std::sqrt(800)},
                  {"share of touching, b", 1},
                  {"height of contact, b", 0.25},
                  {"length of contact", 0.5},
                  {"width of contact", 0.1},
                  {"uprightness of contact", 1},
                  {"contacts, a", 5},
                  {"contacts, b", 1}});
}

TEST(JoiningFeatures, PiecesThatDoNotTouchSaySo)
{
  const PiecePair pair{box({0, 0, 0}, {1, 1, 1}), box({2, 0, 1}, {3, 1, 2})};
  expectFeatures(pair.features(),
                 {{"touching share, a", 0},
                  {"share of touching, a", 0},
                  {"height of contact, a", 1}, // half-way between both
                  {"height of contact, b", 0},
                  {"length of contact", 0},
                  {"uprightness of contact", -1},
                  {"bend", -90},
                  {"deviation of bend", -1},
                  {"log bends", std::log(0.5)},
                  {"concave share", -1},
                  {"gap", 1},
                  {"log near cells", std::log(0.5)},
                  {"near in line", -1}});
}

TEST(JoiningFeatures, BendsAndGapsAreMeans)
{
  PiecePair pair{box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})};
  auto& contact = pair.contact;
  for (const double bend : {10.0, 10.0, 40.0, -20.0}) {
    contact.bends += 1;
    contact.bend_sum += bend;
    contact.bend_squares += bend * bend;
    contact.concave_bends += bend > 0;
  }
  contact.gap = 0.05;
  contact.near_cells = 8;
  contact.near_in_line = 2;
  expectFeatures(pair.features(),
                 {{"bend", 10},
                  {"deviation of bend", std::sqrt(450)},
                  {"log bends", std::log(4)},
                  {"concave share", 0.75},
                  {"gap", 0.05},
                  {"log near cells", std::log(8)},
                  {"near in line", 0.25}});
}

TEST(JoiningFeatures, VotesAreComparedPerVoxel)
{
  PiecePair pair{box({0, 0, 0}, {1, 1, 1}), box({2, 0, 0}, {3, 1, 1})};
  const auto without = pair.features();
  for (auto i = indexOf("likeness of votes"); i <= indexOf("middles of b off a"); ++i)
    EXPECT_EQ(without[i], 0) << joiningFeatureNames()[i];
  const double voxels = pair.a.positions.count, others = pair.b.positions.count;
  const auto share = [](std::vector<double> classes, double count) {
    for (auto& sum : classes)
      sum *= count;
    return classes;
  };
  pair.a.votes.classes = share({0.1, 0.1, 0, 0.64, 0.16}, voxels);
  pair.b.votes.classes = share({0, 0.2, 0.2, 0.36, 0.24}, others);
  for (const double x : {0.4, 0.6}) // spread by 0.1 about their mean
    pair.a.votes.middles.add({x, 0.5, 0.5});
  pair.b.votes.middles.add({1.5, 0.5, 0.5});
  expectFeatures(
      pair.features(),
      {{"likeness of votes",
        std::sqrt(0.02) + std::sqrt(0.64 * 0.36) + std::sqrt(0.16 * 0.24)},
       {"same vote", 0.02 + 0.64 * 0.36 + 0.16 * 0.24},
       {"votes for the building, a", 0.2},
       {"votes for the building, b", 0.4},
       {"most votes for an object, a", 0.64},
       {"most votes for an object, b", 0.36},
       {"distance of middles", 1},
       {"distance of middles over their spreads", 1 / (0.1 + pair_voxel_size)},
       {"spread of middles, a", 0.1},
       {"spread of middles, b", 0},
       {"middles of a off b", 2},
       {"middles of b off a", 1}});
}

TEST(JoiningFeatures, OutlinesLieWithinARectangle)
{
  // Squares along a diagonal: together a hexagon of 5 square metres, in a rectangle of
  // 3 sqrt(2) x sqrt(2), with 2 sqrt(2) between their middles.
  PiecePair pair{box({0, 0, 0}, {1, 1, 1}), box({2, 2, 0}, {3, 3, 1})};
  for (int side = 0; side < 2; ++side) {
    expectFeatures(pair.features(),
                   {{"off the middle, least", 0},
                    {"off the middle, most", 2.0 / 3},
                    {"outline in its rectangle", 5.0 / 6},
                    {"gap of outlines", 3.0 / 5}});
    std::swap(pair.a, pair.b);
  }
  // Together 4 m x 1 m; their middles are 3 m apart along it, 0.25 m across.
  const PiecePair along{box({0, 0, 0}, {1, 0.5f, 1}), box({3, 0, 0}, {4, 1, 1})};
  expectFeatures(along.features(),
                 {{"off the middle, least", 0.25}, {"off the middle, most", 0.75}});
  const PiecePair within{box({1, 1, 0}, {2, 2, 1}), box({0, 0, 0}, {3, 3, 1})};
  expectFeatures(within.features(),
                 {{"off the middle, least", 0},
                  {"off the middle, most", 0},
                  {"outline in its rectangle", 1},
                  {"gap of outlines", 0},
                  {"open gap", 0},
                  {"filled gap", 0}});
}

TEST(JoiningFeatures, TellWhatIsSeenBetweenAndBelow)
{
  PiecePair pair{box({0, 0, 0.6f}, {1, 1, 0.72f}), box({2, 0, 0.6f}, {3, 1, 0.72f})};
  Places voxels;
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 34; ++j) {
      const float x = 0.03f * static_cast<float>(i), y = 0.03f * static_cast<float>(j);
      if (x >= 0.5f)
        voxels.emplace_back(x, y, 0);
      if (x > 1.02f && x < 1.5f)
        voxels.emplace_back(x, y, 0.66f);
    }
  pair.columns = {voxels, 0, pair_voxel_size};
  expectFeatures(pair.features(),
                 {{"gap of outlines", 1.0 / 3},
                  {"open gap", 0.5 / 3},
                  {"filled gap", 0.5 / 3},
                  {"floor below, a", 0.5},
                  {"floor below, b", 1}},
                 0.05);
}
