/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "objects/graph/border_clustering.h"
#include "support/labelled_points.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

using namespace pcl::indoor;
using Labels = std::vector<std::uint32_t>;

namespace {

std::vector<Border>
randomBorders(std::uint32_t nodes, std::size_t count, std::mt19937& rng)
{
  std::vector<Border> borders;
  for (std::size_t i = 0; i < count; ++i) {
    const auto a = static_cast<std::uint32_t>(rng() % nodes);
    const auto b = static_cast<std::uint32_t>(rng() % nodes);
    // Primes over powers of two: sums are exact, and equal means are rare.
    borders.push_back({a,
                       b,
                       static_cast<double>(rng() % 8191) / 64 - 60,
                       static_cast<double>(1 + rng() % 16)});
  }
  return borders;
}

/** Average linkage to the letter: all means anew before every step. */
Labels
clusterLiterally(std::uint32_t nodes,
                 const std::vector<Border>& borders,
                 double threshold)
{
  Labels segment(nodes);
  for (std::uint32_t i = 0; i < nodes; ++i)
    segment[i] = i;
  for (;;) {
    double lowest = std::numeric_limits<double>::max();
    std::uint32_t best_a = 0, best_b = 0;
    for (std::uint32_t a = 0; a < nodes; ++a)
      for (std::uint32_t b = a + 1; b < nodes; ++b) {
        double cost = 0, length = 0;
        for (const auto& border : borders) {
          const auto s = segment[border.source], t = segment[border.target];
          if (std::minmax(s, t) == std::minmax(a, b)) {
            cost += border.cost * border.length;
            length += border.length;
          }
        }
        if (length > 0 && cost / length < lowest) {
          lowest = cost / length;
          best_a = a;
          best_b = b;
        }
      }
    if (!(lowest <= threshold))
      return segment;
    std::replace(segment.begin(), segment.end(), best_b, best_a);
  }
}

Labels
named(Labels labels)
{
  for (auto& label : labels)
    ++label;
  labels = test::renamed(labels);
  for (auto& label : labels)
    --label;
  return labels;
}

} // namespace

TEST(BorderClustering, AgreesWithTheDefinition)
{
  std::mt19937 rng(21);
  std::set<std::size_t> segment_counts;
  for (int trial = 0; trial < 60; ++trial) {
    const auto borders = randomBorders(12, 25, rng);
    const double threshold = static_cast<double>(rng() % 80) - 40;
    const auto labels = clusterByBorders(12, borders, threshold, 1);
    EXPECT_EQ(labels, named(clusterLiterally(12, borders, threshold)))
        << "trial " << trial;
    segment_counts.insert(std::set<std::uint32_t>(labels.begin(), labels.end()).size());
  }
  EXPECT_GT(segment_counts.size(), 5u);
}

TEST(BorderClustering, TheWholeBorderDecidesNotItsBestEdge)
{
  // Two pairs, each joined first; between them one good edge and three bad ones.
  const std::vector<Border> borders{
      {0, 1, -5, 1}, {2, 3, -5, 1}, {0, 2, 0, 1}, {1, 3, 40, 3}};
  EXPECT_EQ(clusterByBorders(4, borders, 29, 1), (Labels{0, 0, 1, 1}));
  EXPECT_EQ(clusterByBorders(4, borders, 30, 1), (Labels{0, 0, 0, 0}));
}

TEST(BorderClustering, SmallSegmentsJoinOverTheirCheapestBorder)
{
  const std::vector<Border> borders{
      {0, 1, 0, 1}, {3, 4, 0, 1}, {1, 2, 50, 1}, {2, 3, 45, 1}};
  EXPECT_EQ(clusterByBorders(5, borders, 10, 1), (Labels{0, 0, 1, 2, 2}));
  EXPECT_EQ(clusterByBorders(5, borders, 10, 2), (Labels{0, 0, 1, 1, 1}));
}

TEST(BorderClustering, OrderOfBordersDoesNotMatter)
{
  std::mt19937 rng(22);
  for (int trial = 0; trial < 20; ++trial) {
    const auto borders = randomBorders(60, 200, rng);
    std::vector<Border> shuffled;
    for (const auto i : test::shuffledOrder(borders.size(), rng)) {
      shuffled.push_back(borders[i]);
      std::swap(shuffled.back().source, shuffled.back().target);
    }
    EXPECT_EQ(clusterByBorders(60, borders, 5, 3),
              clusterByBorders(60, shuffled, 5, 3));
  }
}

TEST(BorderClustering, EmptyAndBadInput)
{
  EXPECT_TRUE(clusterByBorders(0, {}, 0, 1).empty());
  EXPECT_EQ(clusterByBorders(2, {}, 0, 5), (Labels{0, 1}));
  EXPECT_EQ(clusterByBorders(2, {{1, 1, 0, 1}}, 0, 5), (Labels{0, 1}));
  EXPECT_THROW(clusterByBorders(2, {{0, 2, 0, 1}}, 0, 1), pcl::BadArgumentException);
  EXPECT_THROW(clusterByBorders(2, {{0, 1, 0, 0}}, 0, 1), pcl::BadArgumentException);
  EXPECT_THROW(clusterByBorders(2, {{0, 1, std::nan(""), 1}}, 0, 1),
               pcl::BadArgumentException);
}
