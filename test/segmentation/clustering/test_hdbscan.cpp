/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "clustering/single_linkage.h"
#include <pcl/segmentation/hdbscan.h>

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include "segmentation/clustering/hdbscan_brute_force.h"

#include <map>
#include <random>

using pcl::indoor::ClusterSelection;
using pcl::indoor::hdbscan;
using pcl::indoor::HDBSCANEdge;
using pcl::indoor::HDBSCANOptions;
using pcl::indoor::HDBSCANResult;
using Matrix = HDBSCANBruteForce::Matrix;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/** Points in a few clumps on an integer lattice: ties and duplicates abound. */
Matrix
clumpDistances(std::size_t n, std::mt19937& rng)
{
  std::vector<std::pair<int, int>> points;
  for (std::size_t i = 0; i < n; ++i) {
    const int clump = static_cast<int>(rng() % 3) * 9;
    points.emplace_back(clump + static_cast<int>(rng() % 5),
                        static_cast<int>(rng() % 5));
  }
  Matrix d(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      d[i][j] = std::hypot(points[i].first - points[j].first,
                           points[i].second - points[j].second);
  return d;
}

/** No metric at all: a few distances, drawn for each pair. */
Matrix
arbitraryDistances(std::size_t n, unsigned values, std::mt19937& rng)
{
  Matrix d(n, std::vector<double>(n, 0.0));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      d[i][j] = d[j][i] = static_cast<double>(rng() % values) / 3.0;
  return d;
}

HDBSCANOptions
randomHierarchyOptions(std::mt19937& rng)
{
  HDBSCANOptions options;
  options.min_cluster_size = 2 + rng() % 5;
  options.min_samples = rng() % 6;
  options.selection =
      rng() % 3 ? ClusterSelection::ExcessOfMass : ClusterSelection::Leaf;
  options.epsilon = rng() % 2 ? 0.0 : static_cast<double>(rng() % 40) / 10.0;
  options.allow_single_cluster = rng() % 2;
  return options;
}

HDBSCANResult
hdbscanDense(const Matrix& d, const HDBSCANOptions& options)
{
  return hdbscan(
      d.size(), [&](std::size_t i, std::size_t j) { return d[i][j]; }, options);
}

std::vector<HDBSCANEdge>
finiteEdges(const Matrix& d)
{
  std::vector<HDBSCANEdge> edges;
  for (std::uint32_t i = 0; i < d.size(); ++i)
    for (std::uint32_t j = 0; j < i; ++j)
      if (std::isfinite(d[i][j]))
        edges.push_back({i, j, d[i][j]});
  return edges;
}

/** Labels renumbered by first point. */
std::vector<int>
canonical(const std::vector<int>& labels)
{
  std::map<int, int> name;
  std::vector<int> result;
  for (const int label : labels)
    result.push_back(
        label < 0 ? -1
                  : name.emplace(label, static_cast<int>(name.size())).first->second);
  return result;
}

void
expectEqualsBruteForce(const Matrix& d, const HDBSCANOptions& options, int trial)
{
  const HDBSCANBruteForce expected(d, options);
  const auto result = hdbscanDense(d, options);
  ASSERT_EQ(result.labels, expected.labels)
      << "trial " << trial << ", " << d.size() << " points, min_cluster_size "
      << options.min_cluster_size << ", min_samples " << options.min_samples
      << ", epsilon " << options.epsilon << ", single " << options.allow_single_cluster;
  for (std::size_t i = 0; i < d.size(); ++i)
    // sums and quotients of a few doubles
    ASSERT_NEAR(result.probabilities[i], expected.probabilities[i], 1e-12)
        << "trial " << trial << ", point " << i;
}

} // namespace

TEST(HDBSCAN, EqualsBruteForceOnLattices)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 400; ++trial)
    expectEqualsBruteForce(
        clumpDistances(1 + rng() % 45, rng), randomHierarchyOptions(rng), trial);
}

TEST(HDBSCAN, EqualsBruteForceOnArbitraryDistances)
{
  std::mt19937 rng(2);
  for (int trial = 0; trial < 400; ++trial) {
    auto d = arbitraryDistances(1 + rng() % 30, 2 + rng() % 300, rng);
    if (trial % 3 == 0) // far pairs fall out
      for (auto& row : d)
        for (double& value : row)
          if (value > 20.0)
            value = infinity;
    expectEqualsBruteForce(d, randomHierarchyOptions(rng), trial);
  }
}

TEST(HDBSCAN, TheGraphOfAllPairsEqualsTheDenseDistances)
{
  std::mt19937 rng(3);
  for (int trial = 0; trial < 300; ++trial) {
    auto d = arbitraryDistances(1 + rng() % 30, 2 + rng() % 200, rng);
    for (auto& row : d)
      for (double& value : row)
        if (value > 5.0 + trial)
          value = infinity;
    const auto options = randomHierarchyOptions(rng);
    auto edges = finiteEdges(d);
    const auto dense = hdbscanDense(d, options);
    for (std::size_t k = edges.size(); k-- > 0;) // worse copies and loops do not matter
      if (rng() % 4 == 0)
        edges.push_back({edges[k].target, edges[k].source, edges[k].distance + 1.0});
    edges.push_back({0, 0, 0.0});
    // the farthest point stands in for a missing neighbour only in the dense version
    const auto k = options.min_samples ? options.min_samples : options.min_cluster_size;
    if (k <= d.size()) {
      const auto sparse = hdbscan(d.size(), edges, options);
      ASSERT_EQ(sparse.labels, dense.labels) << "trial " << trial;
      ASSERT_EQ(sparse.probabilities, dense.probabilities) << "trial " << trial;
      ASSERT_EQ(sparse.outlier_scores, dense.outlier_scores) << "trial " << trial;
    }
  }
}

TEST(HDBSCAN, AnyPointOrderGivesTheSamePartition)
{
  std::mt19937 rng(4);
  for (int trial = 0; trial < 200; ++trial) {
    const auto d = trial % 2 ? clumpDistances(60, rng)
                             : arbitraryDistances(40, 2 + rng() % 60, rng);
    const std::size_t n = d.size();
    const auto options = randomHierarchyOptions(rng);
    const auto result = hdbscanDense(d, options);
    std::vector<std::size_t> order(n);
    for (std::size_t i = 0; i < n; ++i)
      order[i] = i;
    for (std::size_t i = n; i > 1; --i)
      std::swap(order[i - 1], order[rng() % i]);
    const auto shuffled = hdbscan(
        n,
        [&](std::size_t i, std::size_t j) { return d[order[i]][order[j]]; },
        options);
    std::vector<int> back(n);
    for (std::size_t i = 0; i < n; ++i) {
      back[order[i]] = shuffled.labels[i];
      // to the last bit: sums are taken in an order that the points do not set
      ASSERT_EQ(result.probabilities[order[i]], shuffled.probabilities[i]);
      ASSERT_EQ(result.outlier_scores[order[i]], shuffled.outlier_scores[i]);
    }
    ASSERT_EQ(canonical(back), result.labels) << "trial " << trial;
  }
}

TEST(HDBSCAN, CopiesOfAPointShareItsLabel)
{
  std::mt19937 rng(6);
  for (int trial = 0; trial < 200; ++trial) {
    const auto d = clumpDistances(5 + rng() % 40, rng);
    std::vector<std::size_t> order(d.size() + d.size() / 2);
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i < d.size() ? i : rng() % d.size();
    const auto result = hdbscan(
        order.size(),
        [&](std::size_t i, std::size_t j) { return d[order[i]][order[j]]; },
        randomHierarchyOptions(rng));
    for (std::size_t k = d.size(); k < order.size(); ++k) {
      ASSERT_EQ(result.labels[k], result.labels[order[k]]) << "trial " << trial;
      ASSERT_EQ(result.probabilities[k], result.probabilities[order[k]])
          << "trial " << trial;
    }
  }
}

TEST(HDBSCAN, DoesNotDependOnThreads)
{
  std::mt19937 rng(5);
  std::vector<std::pair<double, double>> points;
  for (int i = 0; i < 3000; ++i)
    points.emplace_back(rng() % 100, rng() % 60);
  const auto distance = [&](std::size_t i, std::size_t j) {
    return std::hypot(points[i].first - points[j].first,
                      points[i].second - points[j].second);
  };
  HDBSCANOptions options;
  options.threads = 1;
  const auto one = hdbscan(points.size(), distance, options);
  options.threads = 8;
  const auto eight = hdbscan(points.size(), distance, options);
  EXPECT_EQ(one.labels, eight.labels);
  EXPECT_EQ(one.probabilities, eight.probabilities);
  EXPECT_EQ(one.stabilities, eight.stabilities);
  // the spanning tree alone, in shares so small that the threads really share it
  const std::size_t few = 400;
  const auto core = pcl::indoor::hdbscan_detail::coreDistances(few, distance, 4, 3);
  const auto alone = pcl::indoor::hdbscan_detail::spanningTree(core, distance, 1);
  const auto shared = pcl::indoor::hdbscan_detail::spanningTree(core, distance, 3, 50);
  ASSERT_EQ(alone.size(), shared.size());
  for (std::size_t k = 0; k < alone.size(); ++k) {
    EXPECT_EQ(alone[k].source, shared[k].source);
    EXPECT_EQ(alone[k].target, shared[k].target);
    EXPECT_EQ(alone[k].distance, shared[k].distance);
  }
}

TEST(HDBSCAN, FindsTwoClumpsAndAnOutlier)
{
  const std::vector<double> x{0.0, 0.1, 0.2, 5.0, 5.1, 5.2, 100.0, 0.3};
  HDBSCANOptions options;
  options.min_cluster_size = 3;
  const auto result = hdbscan(
      x.size(),
      [&](std::size_t i, std::size_t j) { return std::abs(x[i] - x[j]); },
      options);
  EXPECT_EQ(result.labels, (std::vector<int>{0, 0, 0, 1, 1, 1, -1, 0}));
  EXPECT_EQ(result.stabilities.size(), 2u);
  EXPECT_GT(result.outlier_scores[6], 0.9);
  EXPECT_EQ(result.probabilities[6], 0.0);
  ASSERT_EQ(result.clusters.size(), 3u);
  EXPECT_EQ(result.clusters[0].size, 8u);
  EXPECT_EQ(result.clusters[0].label, -1);
  EXPECT_EQ(result.clusters[1].parent, 0);
  EXPECT_EQ(result.clusters[1].size + result.clusters[2].size, 7u);
  EXPECT_NEAR(result.clusters[1].birth_distance, 4.7, 1e-9);
}

TEST(HDBSCAN, OfEquallyStableClustersTheLargerOneWins)
{
  // two clumps: within them 1/2, between them 1; 6 points leave the whole at density 1,
  // 2 x 3 points leave the clumps at density 2, born at 1
  const auto distance = [](std::size_t i, std::size_t j) {
    return i / 3 == j / 3 ? 0.5 : 1.0;
  };
  HDBSCANOptions options;
  options.min_cluster_size = 3;
  EXPECT_EQ(hdbscan(6, distance, options).labels, (std::vector<int>{0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(hdbscan(6, distance, options).stabilities, (std::vector<double>{3.0, 3.0}));
  options.allow_single_cluster = true;
  EXPECT_EQ(hdbscan(6, distance, options).labels, std::vector<int>(6, 0));
}

TEST(HDBSCAN, HandlesLittleInput)
{
  const auto zero = [](std::size_t, std::size_t) { return 0.0; };
  EXPECT_TRUE(hdbscan(0, zero, {}).labels.empty());
  EXPECT_TRUE(hdbscan(0, zero, {}).clusters.empty());
  EXPECT_EQ(hdbscan(1, zero, {}).labels, (std::vector<int>{-1}));
  EXPECT_EQ(hdbscan(9, zero, {}).labels, std::vector<int>(9, -1));
  HDBSCANOptions single;
  single.allow_single_cluster = true;
  EXPECT_EQ(hdbscan(9, zero, single).labels, std::vector<int>(9, 0));
  EXPECT_EQ(hdbscan(4, zero, single).labels, std::vector<int>(4, -1));
  EXPECT_EQ(hdbscan(3, std::vector<HDBSCANEdge>{}, single).labels,
            std::vector<int>(3, -1));
}

TEST(HDBSCAN, CoreDistancesOfTheCallerCount)
{
  // two pairs; the second is only reachable late
  const std::vector<HDBSCANEdge> edges{{0, 1, 1.0}, {1, 2, 9.0}, {2, 3, 1.0}};
  HDBSCANOptions options;
  options.min_cluster_size = 2;
  const auto plain = hdbscan(4, edges, {0.0, 0.0, 0.0, 0.0}, options);
  EXPECT_EQ(plain.labels, (std::vector<int>{0, 0, 1, 1}));
  const auto sparse = hdbscan(4, edges, {0.0, 0.0, 9.0, 9.0}, options);
  EXPECT_EQ(sparse.labels, std::vector<int>(4, -1));
}

TEST(HDBSCAN, RejectsBadInput)
{
  const auto one = [](std::size_t, std::size_t) { return 1.0; };
  const auto negative = [](std::size_t, std::size_t) { return -1.0; };
  const auto not_a_number = [](std::size_t, std::size_t) { return std::nan(""); };
  HDBSCANOptions options;
  EXPECT_THROW(hdbscan(9, negative, options), pcl::BadArgumentException);
  EXPECT_THROW(hdbscan(9, not_a_number, options), pcl::BadArgumentException);
  options.min_samples = 1;
  EXPECT_THROW(hdbscan(9, not_a_number, options), pcl::BadArgumentException);
  options.min_cluster_size = 1;
  EXPECT_THROW(hdbscan(9, one, options), pcl::BadArgumentException);
  options = {};
  options.epsilon = std::nan("");
  EXPECT_THROW(hdbscan(9, one, options), pcl::BadArgumentException);
  options = {};
  const auto cluster = [&](const std::vector<HDBSCANEdge>& edges) {
    return hdbscan(3, edges, options);
  };
  EXPECT_THROW(cluster({{0, 3, 1.0}}), pcl::BadArgumentException);
  EXPECT_THROW(cluster({{0, 1, -1.0}}), pcl::BadArgumentException);
  EXPECT_THROW(hdbscan(3, std::vector<HDBSCANEdge>{}, {0.0}, options),
               pcl::BadArgumentException);
  EXPECT_THROW(pcl::indoor::hdbscanFromSpanningForest(
                   3, {{0, 1, 1.0}, {1, 2, 1.0}, {2, 0, 1.0}}, options),
               pcl::BadArgumentException);
}

TEST(SingleLinkageTree, MergesEqualDistancesAtOnce)
{
  const auto tree = pcl::indoor::singleLinkageTree(
      5, {{0, 1, 1.0}, {3, 4, 1.0}, {2, 3, 2.0}, {1, 2, 2.0}});
  ASSERT_EQ(tree.distance.size() - tree.count, 3u);
  int children = 0;
  tree.forEachChild(tree.root, [&](int) { ++children; });
  EXPECT_EQ(children, 3);
  EXPECT_EQ(tree.size[static_cast<std::size_t>(tree.root)], 5u);
  EXPECT_EQ(pcl::indoor::singleLinkageTree(0, {}).root, -1);
  EXPECT_EQ(pcl::indoor::singleLinkageTree(1, {}).root, 0);
}

TEST(SingleLinkageTree, LongChainsNeedNoDeepStack)
{
  std::vector<HDBSCANEdge> chain;
  constexpr std::uint32_t kLength = 300000;
  for (std::uint32_t i = 1; i < kLength; ++i)
    chain.push_back({i - 1, i, static_cast<double>(i)});
  HDBSCANOptions options;
  options.allow_single_cluster = true;
  const auto result = pcl::indoor::hdbscanFromSpanningForest(kLength, chain, options);
  EXPECT_EQ(result.labels, std::vector<int>(kLength, 0));
}
