/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/labelled_points.h"
#include "thesis/objects/graph_segmentation.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

using namespace pcl::indoor;
using Labels = std::vector<std::uint32_t>;

namespace {

std::vector<WeightedEdge>
randomGraph(std::uint32_t nodes, std::size_t count, std::mt19937& rng)
{
  std::vector<WeightedEdge> edges;
  std::set<std::pair<std::uint32_t, std::uint32_t>> used;
  while (edges.size() < count) {
    const auto a = static_cast<std::uint32_t>(rng() % nodes);
    const auto b = static_cast<std::uint32_t>(rng() % nodes);
    if (a == b || !used.insert(std::minmax(a, b)).second)
      continue;
    edges.push_back({a, b, static_cast<float>(rng() % 8) / 8}); // ties occur
  }
  return edges;
}

Labels
componentsBruteForce(std::uint32_t nodes, const std::vector<WeightedEdge>& edges)
{
  Labels label(nodes);
  for (std::uint32_t i = 0; i < nodes; ++i)
    label[i] = i;
  for (std::uint32_t round = 0; round < nodes; ++round)
    for (const auto& edge : edges)
      label[edge.source] = label[edge.target] =
          std::min(label[edge.source], label[edge.target]);
  return label;
}

/** Eq. (2.14) to (2.17) to the letter: Int(C) as largest edge of a minimum spanning
 * tree of the segment, sizes by counting. */
Labels
segmentLiterally(std::uint32_t nodes, std::vector<WeightedEdge> edges, float scale)
{
  for (auto& edge : edges)
    if (edge.target < edge.source)
      std::swap(edge.source, edge.target);
  std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) {
    return std::tie(a.weight, a.source, a.target) <
           std::tie(b.weight, b.source, b.target);
  });
  Labels segment(nodes);
  for (std::uint32_t i = 0; i < nodes; ++i)
    segment[i] = i;
  const auto largest_in_tree = [&](std::uint32_t c) {
    Labels tree(nodes); // Kruskal's tree within the segment
    for (std::uint32_t i = 0; i < nodes; ++i)
      tree[i] = i;
    float largest = 0;
    for (const auto& edge : edges) {
      if (segment[edge.source] != c || segment[edge.target] != c ||
          tree[edge.source] == tree[edge.target])
        continue;
      const auto from = tree[edge.source], to = tree[edge.target];
      std::replace(tree.begin(), tree.end(), from, to);
      largest = edge.weight;
    }
    return largest;
  };
  const auto bound = [&](std::uint32_t c) {
    const auto size = std::count(segment.begin(), segment.end(), c);
    return largest_in_tree(c) + scale / static_cast<float>(size);
  };
  for (const auto& edge : edges) {
    const auto a = segment[edge.source], b = segment[edge.target];
    if (a != b && edge.weight <= std::min(bound(a), bound(b)))
      std::replace(segment.begin(), segment.end(), b, a);
  }
  return segment;
}

/** Equal up to names. */
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

TEST(GraphSegmentation, HugeScaleGivesTheConnectedComponents)
{
  std::mt19937 rng(42);
  for (int trial = 0; trial < 50; ++trial) {
    const auto edges = randomGraph(30, 25, rng);
    EXPECT_EQ(segmentGraph(30, edges, 1e9f, 1), named(componentsBruteForce(30, edges)))
        << "trial " << trial;
  }
}

TEST(GraphSegmentation, AgreesWithTheDefinition)
{
  std::mt19937 rng(43);
  std::size_t several = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const auto edges = randomGraph(25, 60, rng);
    const float scale = static_cast<float>(rng() % 30) / 10;
    const auto labels = segmentGraph(25, edges, scale, 1);
    EXPECT_EQ(labels, named(segmentLiterally(25, edges, scale))) << "trial " << trial;
    several += *std::max_element(labels.begin(), labels.end()) > 0;
  }
  EXPECT_GT(several, 50u);
}

TEST(GraphSegmentation, OrderOfEdgesDoesNotMatter)
{
  std::mt19937 rng(44);
  for (int trial = 0; trial < 20; ++trial) {
    const auto edges = randomGraph(40, 90, rng);
    std::vector<WeightedEdge> shuffled;
    for (const auto i : test::shuffledOrder(edges.size(), rng)) {
      shuffled.push_back(edges[i]);
      std::swap(shuffled.back().source, shuffled.back().target);
    }
    EXPECT_EQ(segmentGraph(40, edges, 1, 3), segmentGraph(40, shuffled, 1, 3));
  }
}

TEST(GraphSegmentation, SegmentsHaveTheMinimumSizeWhereTheGraphAllows)
{
  std::mt19937 rng(45);
  for (int trial = 0; trial < 50; ++trial) {
    const auto edges = randomGraph(30, 40, rng);
    const auto components = componentsBruteForce(30, edges);
    const auto labels = segmentGraph(30, edges, 0.2f, 4);
    for (std::uint32_t i = 0; i < 30; ++i)
      EXPECT_GE(
          std::count(labels.begin(), labels.end(), labels[i]),
          std::min<std::ptrdiff_t>(
              4, std::count(components.begin(), components.end(), components[i])));
  }
}

TEST(GraphSegmentation, EmptySingleAndIsolated)
{
  EXPECT_TRUE(segmentGraph(0, {}, 3, 3).empty());
  EXPECT_EQ(segmentGraph(1, {}, 3, 3), Labels{0});
  EXPECT_EQ(segmentGraph(3, {}, 3, 3), (Labels{0, 1, 2}));
  EXPECT_EQ(segmentGraph(2, {{1, 1, 0.5f}}, 3, 3), (Labels{0, 1}));
}

TEST(GraphSegmentation, RejectsBadInput)
{
  EXPECT_THROW(segmentGraph(2, {{0, 2, 1}}, 3, 3), pcl::BadArgumentException);
  EXPECT_THROW(segmentGraph(2, {{0, 1, -1}}, 3, 3), pcl::BadArgumentException);
  EXPECT_THROW(segmentGraph(2, {{0, 1, std::nanf("")}}, 3, 3),
               pcl::BadArgumentException);
  EXPECT_THROW(segmentGraph(2, {}, -1, 3), pcl::BadArgumentException);
}
