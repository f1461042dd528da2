/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "segmentation/objects/join/joining_brute_force.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

using Labels = std::vector<std::uint32_t>;

/** Joins of random unions, by descending level. */
std::vector<PieceJoin>
randomJoins(std::uint32_t piece_count, std::size_t count, std::mt19937& rng)
{
  Labels left(piece_count);
  std::iota(left.begin(), left.end(), 0u);
  std::vector<PieceJoin> joins;
  for (std::size_t j = 0; j < count; ++j) {
    std::shuffle(left.begin(), left.end(), rng);
    const auto first = left[0], second = left[1];
    joins.push_back({std::min(first, second),
                     std::max(first, second),
                     1 - static_cast<float>(j + 1) / static_cast<float>(count + 2)});
    left.erase(std::find(left.begin(), left.end(), joins.back().gone));
  }
  return joins;
}

/** The children of each node of the tree, none of a piece, and the nodes on top. */
struct Nodes {
  std::vector<std::vector<std::size_t>> children;
  std::vector<std::size_t> roots;

  Nodes(std::size_t piece_count, const std::vector<PieceJoin>& joins)
  : children(piece_count)
  {
    std::vector<std::size_t> node(piece_count);
    std::iota(node.begin(), node.end(), std::size_t(0));
    std::vector<bool> is_top(piece_count, true);
    for (const auto& join : joins) {
      is_top[node[join.kept]] = is_top[node[join.gone]] = false;
      children.push_back({node[join.kept], node[join.gone]});
      node[join.kept] = children.size() - 1;
      is_top.push_back(true);
    }
    for (std::size_t i = 0; i < is_top.size(); ++i)
      if (is_top[i])
        roots.push_back(i);
  }
};

/** What each way to cut below a node is worth. */
std::vector<float>
valuesOfAllCuts(const Nodes& nodes,
                const std::vector<PieceJoin>& joins,
                const std::vector<float>& worth,
                float level,
                std::size_t node)
{
  std::vector<float> values{worth[node]};
  if (nodes.children[node].empty())
    return values;
  const auto& join = joins[node - (worth.size() - joins.size())];
  const float apart = join.level >= level ? -0.15f : 0.15f;
  const auto cuts = [&](std::size_t child) {
    return valuesOfAllCuts(nodes, joins, worth, level, child);
  };
  for (const float first : cuts(nodes.children[node][0]))
    for (const float second : cuts(nodes.children[node][1]))
      values.push_back(first + second + apart);
  return values;
}

/** What the segments below a node are worth. */
float
valueOf(const Labels& segments,
        const Nodes& nodes,
        const std::vector<PieceJoin>& joins,
        const std::vector<float>& worth,
        float level,
        std::size_t node)
{
  Labels found;
  std::vector<std::size_t> below{node};
  while (!below.empty()) {
    const auto next = below.back();
    below.pop_back();
    const auto& children = nodes.children[next];
    below.insert(below.end(), children.begin(), children.end());
    if (children.empty())
      found.push_back(segments[next]);
  }
  if (std::count(found.begin(), found.end(), found.front()) ==
      static_cast<std::ptrdiff_t>(found.size()))
    return worth[node];
  const auto& join = joins[node - (worth.size() - joins.size())];
  float value = join.level >= level ? -0.15f : 0.15f;
  for (const auto child : nodes.children[node])
    value += valueOf(segments, nodes, joins, worth, level, child);
  return value;
}

} // namespace

TEST(BestCut, IsWorthTheMostOfAllCuts)
{
  std::mt19937 rng(1);
  std::size_t split = 0, joined = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto piece_count = 2 + rng() % 7;
    const auto joins = randomJoins(piece_count, rng() % piece_count, rng);
    std::vector<float> worth;
    for (std::size_t i = 0; i < piece_count + joins.size(); ++i)
      worth.push_back(static_cast<float>(rng() % 1000) / 1000 - 0.38f);
    const float level = static_cast<float>(rng() % 10) / 10;
    const auto segments = bestCut(joins, worth, level);
    ASSERT_EQ(segments.size(), piece_count);
    const Nodes nodes(piece_count, joins);
    for (const auto root : nodes.roots) {
      const auto values = valuesOfAllCuts(nodes, joins, worth, level, root);
      ASSERT_NEAR(valueOf(segments, nodes, joins, worth, level, root),
                  *std::max_element(values.begin(), values.end()),
                  1e-5)
          << trial;
    }
    for (const auto segment : segments)
      ASSERT_EQ(segments[segment], segment) << "one of its pieces";
    const auto at_level = segmentsAtLevel(piece_count, joins, level);
    for (std::uint32_t p = 0; p < piece_count; ++p) {
      split += segments[p] == p && at_level[p] != p;
      joined += segments[p] != p && at_level[p] == p;
    }
  }
  EXPECT_GT(split, 20u);
  EXPECT_GT(joined, 20u);
}

TEST(BestCut, OfWorthlessObjectsIsThatOfTheLevel)
{
  std::mt19937 rng(2);
  for (int trial = 0; trial < 50; ++trial) {
    const auto joins = randomJoins(20, 15, rng);
    for (const float level : {0.0f, 0.3f, 0.6f, 1.0f})
      ASSERT_EQ(bestCut(joins, std::vector<float>(35, 0), level),
                segmentsAtLevel(20, joins, level));
  }
  EXPECT_TRUE(bestCut({}, {}, 0.5f).empty());
}

TEST(BestCut, ObjectsAreDescribedAsTheyAreJoined)
{
  struct ByFeatures : JoiningCriterion {
    float
    probability(const JoiningFeatures& features, std::uint32_t, std::uint32_t) override
    {
      return probabilityOf(features);
    }
  };
  const auto indexOf = [](const std::string& name) {
    const auto& names = objectFeatureNames();
    const auto found = std::find(names.begin(), names.end(), name);
    EXPECT_NE(found, names.end()) << name;
    return static_cast<std::size_t>(found - names.begin());
  };
  const auto area = indexOf("log area"), low = indexOf("low"), high = indexOf("high"),
             parts = indexOf("log parts"), own = indexOf("probability of its join"),
             least = indexOf("least probability within"),
             next = indexOf("probability of the next join"),
             other = indexOf("log area of what it joins with, over its own");
  std::mt19937 rng(3);
  for (int trial = 0; trial < 10; ++trial) {
    const auto graph = randomGraph(20, 30, rng);
    ByFeatures criterion;
    const auto tree = joinPieces(graph, criterion, 0.3f);
    ASSERT_EQ(tree.objects.size(), 20 + tree.joins.size());
    ASSERT_GT(tree.joins.size(), 3u);
    const Nodes nodes(20, tree.joins);
    for (std::size_t i = 0; i < tree.objects.size(); ++i) {
      const auto& object = tree.objects[i];
      if (i < 20) {
        EXPECT_NEAR(
            object[area], std::log(graph.pieces[i].positions.count / 1024), 1e-5);
        EXPECT_EQ(object[parts], 0);
        EXPECT_EQ(object[own], 1);
        EXPECT_EQ(object[least], 1);
        continue;
      }
      const auto& join = tree.joins[i - 20];
      const auto &kept = tree.objects[nodes.children[i][0]],
                 &gone = tree.objects[nodes.children[i][1]];
      EXPECT_NEAR(
          std::exp(object[area]), std::exp(kept[area]) + std::exp(gone[area]), 1e-3);
      EXPECT_NEAR(
          std::exp(object[parts]), std::exp(kept[parts]) + std::exp(gone[parts]), 1e-3);
      EXPECT_NEAR(object[low], std::min(kept[low], gone[low]), 1e-5);
      EXPECT_NEAR(object[high], std::max(kept[high], gone[high]), 1e-5);
      EXPECT_EQ(object[least], join.level);
      EXPECT_GE(object[own], join.level);
      EXPECT_EQ(kept[next], object[own]);
      EXPECT_EQ(gone[next], object[own]);
      EXPECT_NEAR(kept[other], gone[area] - kept[area], 1e-5);
      EXPECT_NEAR(gone[other], kept[area] - gone[area], 1e-5);
    }
    for (const auto root : nodes.roots) {
      EXPECT_LT(tree.objects[root][next], 0.3f) << "nothing takes it up";
      EXPECT_EQ(tree.objects[root][other], 0);
    }
    const auto fits = expectedFits(tree, JoiningScale::Objects);
    ASSERT_EQ(fits.size(), tree.objects.size());
    EXPECT_NE(fits, expectedFits(tree, JoiningScale::Parts));
    const auto [worst, best] = std::minmax_element(fits.begin(), fits.end());
    EXPECT_GT(*best, *worst + 0.05f) << "they tell one from another";
    auto reversed = tree;
    std::reverse(reversed.objects.begin(), reversed.objects.end());
    const auto fits_of_reversed = expectedFits(reversed, JoiningScale::Objects);
    EXPECT_TRUE(std::equal(fits.rbegin(), fits.rend(), fits_of_reversed.begin()))
        << "each is of its object alone";
  }
  EXPECT_THROW(expectedFits({}, JoiningScale::View), pcl::BadArgumentException);
}
