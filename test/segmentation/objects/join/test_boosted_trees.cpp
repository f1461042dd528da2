/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "objects/join/boosted_trees.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

using namespace pcl::indoor;

namespace {

BoostedTrees
treesOf(const std::string& text)
{
  std::istringstream stream(text);
  return BoostedTrees::read(stream);
}

double
logistic(double log_odds)
{
  return 1 / (1 + std::exp(-log_odds));
}

/** Two trees of three features; the first asks for 0, then for 2 or 1:
 *
 *     0: f0 <= 0.5 ? node 1 : node 2
 *     1: f2 <= -1 ? 1 : 2     2: f1 <= 3 ? -0.5 : -2.5
 *
 * and the second for 1: f1 <= 0 ? 0.125 : 0.25. */
const std::string two_trees = "trees 3 -0.75 2\n"
                              "7\n"
                              "0 1 0.5\n"
                              "2 3 -1\n"
                              "1 5 3\n"
                              "v1\n"
                              "v2\n"
                              "v-0.5\n"
                              "v-2.5\n"
                              "3\n"
                              "1 1 0\n"
                              "v0.125\n"
                              "v0.25\n";

} // namespace

TEST(BoostedTrees, AgreesWithTreesByHand)
{
  const auto trees = treesOf(two_trees);
  EXPECT_EQ(trees.featureCount(), 3u);
  int seen = 0;
  for (const float f0 : {-7.0f, 0.5f, 0.51f, 9.0f})
    for (const float f1 : {-1.0f, 0.0f, 0.01f, 3.0f, 3.5f})
      for (const float f2 : {-1.5f, -1.0f, -0.9f}) {
        const double first = f0 <= 0.5f ? (f2 <= -1 ? 1 : 2) : (f1 <= 3 ? -0.5 : -2.5);
        const double second = f1 <= 0 ? 0.125 : 0.25;
        const float features[] = {f0, f1, f2};
        EXPECT_NEAR(trees.probability(features), logistic(-0.75 + first + second), 1e-6)
            << f0 << ", " << f1 << ", " << f2;
        ++seen;
      }
  EXPECT_EQ(seen, 60);
}

TEST(BoostedTrees, LeavesAndNoTreesAreTheirValues)
{
  EXPECT_NEAR(treesOf("trees 0 0.25 0").probability(nullptr), logistic(0.25), 1e-6);
  EXPECT_NEAR(
      treesOf("trees 0 0.25 1 1 0 0 -1").probability(nullptr), logistic(-0.75), 1e-6);
  // A leaf asks for nothing: its feature is not looked at.
  EXPECT_NEAR(treesOf("trees 1 0 1 1 9 0 1").probability(nullptr), logistic(1), 1e-6);
  EXPECT_EQ(treesOf("trees 0 1000 0").probability(nullptr), 1);
  EXPECT_EQ(treesOf("trees 0 -1000 0").probability(nullptr), 0);
}

TEST(BoostedTrees, ValuesWithoutOrderGoToTheFirstChild)
{
  const auto trees = treesOf(two_trees);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float nothing[] = {nan, nan, nan}, low[] = {0, 0, -2};
  EXPECT_EQ(trees.probability(nothing), trees.probability(low));
}

TEST(BoostedTrees, SeveralAreReadFromOneStream)
{
  std::istringstream stream("one " + two_trees + "two trees 5 0.5 1 1 0 0 0.25 end");
  std::string name;
  stream >> name;
  EXPECT_EQ(BoostedTrees::read(stream).featureCount(), 3u);
  ASSERT_TRUE(stream >> name);
  EXPECT_EQ(name, "two");
  const auto second = BoostedTrees::read(stream);
  EXPECT_EQ(second.featureCount(), 5u);
  const float features[5] = {};
  EXPECT_NEAR(second.probability(features), logistic(0.75), 1e-6);
  ASSERT_TRUE(stream >> name);
  EXPECT_EQ(name, "end");
}

TEST(BoostedTrees, RejectsWhatIsNoTree)
{
  for (const char* text : {
           "",                                            // nothing
           "tree 1 0 0",                                  // another word
           "trees",                                       // no numbers
           "trees 1 0",                                   // no count
           "trees x 0 0",                                 // no numbers
           "trees 1 x 0",                                 //
           "trees 1 0 x",                                 //
           "trees -1 0 0",                                // not a number of features
           "trees 65536 0 0",                             // too many
           "trees 1 0 -1",                                // not a count
           "trees 1 0 100000",                            // too many
           "trees 1 0 1",                                 // no tree
           "trees 1 0 1 0",                               // an empty one
           "trees 1 0 1 -1",                              //
           "trees 1 0 1 65536",                           // more than can be numbered
           "trees 1 0 1 1 0 0",                           // cut off within a node
           "trees 1 0 1 2 0 0 1",                         // and after one
           "trees 1 0 2 1 0 0 1",                         // the second is missing
           "trees 1 0 1 1 0 0 x",                         // no value
           "trees 1 0 1 1 70000 0 1",                     // too large a number
           "trees 1 0 1 3 1 1 0 0 0 1 0 0 2",             // no such feature
           "trees 1 0 1 3 0 2 0 0 0 1 0 0 2",             // the second child is missing
           "trees 1 0 1 3 0 3 0 0 0 1 0 0 2",             // both are
           "trees 1 0 1 4 0 2 0 0 1 0 0 0 1 0 0 2",       // a node leads to itself
           "trees 1 0 1 5 0 3 0 0 0 0 0 1 0 0 0 1 0 0 2", // or back
           "trees 1 0 1 1 0 0 1e99",                      // no float
           "trees 1 0 1 1 v",                             // a leaf is cut off
           "trees 1 0 1 1 vx",                            // no value
           "trees 1 0 1 1 w1",                            // no leaf
       })
    EXPECT_THROW(treesOf(text), pcl::BadArgumentException) << text;
}
