/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "clustering/single_linkage.h"
#include <pcl/segmentation/dbscan.h>

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using pcl::indoor::dbscan;
using pcl::indoor::DBSCANOptions;
using pcl::indoor::HDBSCANEdge;

namespace {

using Matrix = std::vector<std::vector<double>>;

constexpr double out_of_reach = std::numeric_limits<double>::infinity();

/** A few distances, drawn for each pair: no metric, many ties, some infinite. */
Matrix
randomDistances(std::size_t n, std::mt19937& rng)
{
  Matrix d(n, std::vector<double>(n, 0.0));
  const unsigned values = 3 + rng() % 40;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      d[i][j] = d[j][i] =
          rng() % 10 == 0 ? out_of_reach : static_cast<double>(rng() % values) / 3.0;
  return d;
}

/** Points on a small integer lattice, some of them twice. */
Matrix
latticeDistances(std::size_t n, std::mt19937& rng)
{
  std::vector<std::pair<int, int>> points;
  for (std::size_t i = 0; i < n; ++i)
    points.emplace_back(rng() % 12, rng() % 7);
  Matrix d(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      d[i][j] = std::hypot(points[i].first - points[j].first,
                           points[i].second - points[j].second);
  return d;
}

Matrix
randomMatrix(int trial, std::mt19937& rng)
{
  const std::size_t n = rng() % 45;
  return trial % 2 ? latticeDistances(n, rng) : randomDistances(n, rng);
}

/** Half of the epsilons are distances that occur on the lattice. */
DBSCANOptions
randomOptions(std::mt19937& rng)
{
  DBSCANOptions options;
  options.epsilon = rng() % 2 ? std::hypot(rng() % 3, rng() % 3)
                              : static_cast<double>(rng() % 20) / 3.0;
  options.min_samples = 1 + rng() % 6;
  options.min_cluster_size = 1 + rng() % 4;
  return options;
}

std::vector<int>
dbscanDense(const Matrix& d, const DBSCANOptions& options)
{
  return dbscan(
      d.size(), [&](std::size_t i, std::size_t j) { return d[i][j]; }, options);
}

/** By the definition: count neighbours, flood the core points. */
std::vector<int>
bruteForce(const Matrix& d, const DBSCANOptions& options)
{
  const std::size_t n = d.size();
  std::vector<bool> core(n), seen(n);
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t near = 0;
    for (std::size_t j = 0; j < n; ++j)
      near += j == i || d[i][j] <= options.epsilon;
    core[i] = near >= options.min_samples;
  }
  std::vector<int> labels(n, -1);
  int clusters = 0;
  for (std::size_t start = 0; start < n; ++start) {
    if (!core[start] || seen[start])
      continue;
    std::vector<std::size_t> cluster{start};
    seen[start] = true;
    for (std::size_t k = 0; k < cluster.size(); ++k)
      for (std::size_t j = 0; j < n; ++j)
        if (core[j] && !seen[j] && d[cluster[k]][j] <= options.epsilon) {
          seen[j] = true;
          cluster.push_back(j);
        }
    if (cluster.size() < options.min_cluster_size)
      continue;
    for (const std::size_t i : cluster)
      labels[i] = clusters;
    ++clusters;
  }
  return labels;
}

/** The subtrees of the single-linkage hierarchy at or below a distance; points that
 * stand alone are noise. */
std::vector<int>
cutTree(const pcl::indoor::SingleLinkageTree& tree, double distance)
{
  std::vector<int> labels(tree.count, -1);
  std::vector<int> stack;
  if (tree.root >= 0)
    stack.push_back(tree.root);
  for (int cluster = 0; !stack.empty();) {
    const int node = stack.back();
    stack.pop_back();
    if (static_cast<std::size_t>(node) < tree.count)
      continue;
    if (tree.distance[static_cast<std::size_t>(node)] > distance)
      tree.forEachChild(node, [&](int child) { stack.push_back(child); });
    else {
      tree.forEachPoint(node, [&](std::size_t point) { labels[point] = cluster; });
      ++cluster;
    }
  }
  return labels;
}

void
expectSamePartition(const std::vector<int>& a, const std::vector<int>& b, int trial)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i] < 0, b[i] < 0) << "trial " << trial << ", point " << i;
    for (std::size_t j = 0; j < i; ++j)
      ASSERT_EQ(a[i] == a[j], b[i] == b[j]) << "trial " << trial;
  }
}

} // namespace

TEST(DBSCAN, EqualsBruteForce)
{
  std::mt19937 rng(1);
  int clusters = 0, noise = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Matrix d = randomMatrix(trial, rng);
    const DBSCANOptions options = randomOptions(rng);
    const auto labels = dbscanDense(d, options);
    ASSERT_EQ(labels, bruteForce(d, options))
        << "trial " << trial << ", epsilon " << options.epsilon << ", min_samples "
        << options.min_samples << ", min_cluster_size " << options.min_cluster_size;
    for (const int label : labels) {
      clusters = std::max(clusters, label + 1);
      noise += label < 0;
    }
  }
  EXPECT_GT(clusters, 3); // there was something to compare
  EXPECT_GT(noise, 1000);
}

TEST(DBSCAN, TheGraphOfAllPairsEqualsTheDenseDistances)
{
  std::mt19937 rng(2);
  for (int trial = 0; trial < 300; ++trial) {
    const Matrix d = randomMatrix(trial, rng);
    const DBSCANOptions options = randomOptions(rng);
    std::vector<HDBSCANEdge> edges;
    for (std::uint32_t i = 0; i < d.size(); ++i)
      for (std::uint32_t j = 0; j < i; ++j) {
        if (std::isfinite(d[i][j]))
          edges.push_back({i, j, d[i][j]});
        if (rng() % 4 == 0) // worse copies and loops do not matter
          edges.push_back({j, i, d[i][j] + 1.0});
        if (rng() % 4 == 0)
          edges.push_back({i, i, 0.0});
      }
    ASSERT_EQ(dbscan(d.size(), edges, options), dbscanDense(d, options))
        << "trial " << trial;
  }
}

TEST(DBSCAN, CutsTheSingleLinkageHierarchy)
{
  std::mt19937 rng(3);
  for (int trial = 0; trial < 200; ++trial) {
    const Matrix d = latticeDistances(40, rng);
    DBSCANOptions options = randomOptions(rng);
    options.min_cluster_size = 2;
    const auto distance = [&](std::size_t i, std::size_t j) { return d[i][j]; };
    const auto core = pcl::indoor::hdbscan_detail::coreDistances(
        d.size(), distance, options.min_samples, 1);
    const auto forest = pcl::indoor::hdbscan_detail::spanningTree(core, distance, 1);
    expectSamePartition(
        cutTree(pcl::indoor::singleLinkageTree(d.size(), forest), options.epsilon),
        pcl::indoor::dbscanFromSpanningForest(d.size(), forest, core, options),
        trial);
  }
}

TEST(DBSCAN, AnyPointOrderGivesTheSamePartition)
{
  std::mt19937 rng(4);
  for (int trial = 0; trial < 200; ++trial) {
    const Matrix d = randomMatrix(trial, rng);
    const DBSCANOptions options = randomOptions(rng);
    std::vector<std::size_t> order(d.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[rng() % i]);
    const auto shuffled = dbscan(
        d.size(),
        [&](std::size_t i, std::size_t j) { return d[order[i]][order[j]]; },
        options);
    std::vector<int> back(d.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      back[order[i]] = shuffled[i];
    expectSamePartition(back, dbscanDense(d, options), trial);
  }
}

TEST(DBSCAN, CopiesOfAPointShareItsLabel)
{
  std::mt19937 rng(6);
  for (int trial = 0; trial < 200; ++trial) {
    const Matrix d = latticeDistances(5 + rng() % 40, rng);
    std::vector<std::size_t> order(d.size() + d.size() / 2);
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i < d.size() ? i : rng() % d.size();
    DBSCANOptions options = randomOptions(rng);
    options.min_cluster_size = 1 + rng() % 2;
    const auto labels = dbscan(
        order.size(),
        [&](std::size_t i, std::size_t j) { return d[order[i]][order[j]]; },
        options);
    for (std::size_t k = d.size(); k < order.size(); ++k)
      ASSERT_EQ(labels[k], labels[order[k]]) << "trial " << trial;
  }
}

TEST(DBSCAN, DoesNotDependOnThreads)
{
  std::mt19937 rng(5);
  const Matrix d = latticeDistances(700, rng);
  DBSCANOptions options;
  options.epsilon = 1.0;
  options.min_samples = 40;
  options.threads = 1;
  const auto one = dbscanDense(d, options);
  options.threads = 8;
  EXPECT_EQ(one, dbscanDense(d, options));
  EXPECT_NE(std::count(one.begin(), one.end(), -1), 0);
  EXPECT_NE(std::count(one.begin(), one.end(), 0), 0);
}

TEST(DBSCAN, BorderPointsAreNoise)
{
  // 3 is within 1 of the core points 2 and 4 but has too few neighbours itself
  const std::vector<double> x{0.0, 0.5, 1.0, 2.0, 3.0, 3.5, 4.0, 9.0};
  DBSCANOptions options;
  options.epsilon = 1.0;
  options.min_samples = 3;
  const auto distance = [&](std::size_t i, std::size_t j) {
    return std::abs(x[i] - x[j]);
  };
  EXPECT_EQ(dbscan(x.size(), distance, options),
            (std::vector<int>{0, 0, 0, 0, 0, 0, 0, -1}));
  options.min_samples = 4;
  EXPECT_EQ(dbscan(x.size(), distance, options),
            (std::vector<int>{-1, -1, 0, -1, 1, -1, -1, -1}));
  options.min_cluster_size = 2;
  EXPECT_EQ(dbscan(x.size(), distance, options), std::vector<int>(8, -1));
}

TEST(DBSCAN, HandlesLittleInput)
{
  const auto zero = [](std::size_t, std::size_t) { return 0.0; };
  DBSCANOptions options;
  EXPECT_TRUE(dbscan(0, zero, options).empty());
  EXPECT_EQ(dbscan(4, zero, options), std::vector<int>(4, -1));
  EXPECT_EQ(dbscan(5, zero, options), std::vector<int>(5, 0));
  options.min_samples = 1;
  EXPECT_EQ(dbscan(1, zero, options), std::vector<int>(1, 0));
  EXPECT_EQ(dbscan(2, std::vector<HDBSCANEdge>{}, options), (std::vector<int>{0, 1}));
}

TEST(DBSCAN, RejectsBadInput)
{
  const auto refused = [](const DBSCANOptions& options) {
    EXPECT_THROW(dbscan(
                     9, [](std::size_t, std::size_t) { return 1.0; }, options),
                 pcl::BadArgumentException);
    EXPECT_THROW(dbscan(9, std::vector<HDBSCANEdge>{}, options),
                 pcl::BadArgumentException);
  };
  DBSCANOptions options;
  options.epsilon = -1.0;
  refused(options);
  options.epsilon = std::nan("");
  refused(options);
  options.epsilon = out_of_reach;
  refused(options);
  options = {};
  options.min_samples = 0;
  refused(options);
  options = {};
  options.min_cluster_size = 0;
  refused(options);
  options = {};
  EXPECT_THROW(dbscan(
                   9, [](std::size_t, std::size_t) { return -1.0; }, options),
               pcl::BadArgumentException);
  EXPECT_THROW(dbscan(3, std::vector<HDBSCANEdge>{{0, 3, 1.0}}, options),
               pcl::BadArgumentException);
  EXPECT_THROW(dbscan(3, std::vector<HDBSCANEdge>{{0, 1, -1.0}}, options),
               pcl::BadArgumentException);
  EXPECT_THROW(
      pcl::indoor::dbscanFromSpanningForest(3, {{0, 3, 1.0}}, {0, 0, 0}, options),
      pcl::BadArgumentException);
  EXPECT_THROW(pcl::indoor::dbscanFromSpanningForest(3, {}, {0, 0}, options),
               pcl::BadArgumentException);
}
