/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "thesis/rooms/map_random_walker.h"

#include <pcl/exceptions.h>
#include <pcl/segmentation/random_walker.h>

#include <boost/graph/adjacency_list.hpp>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

using pcl::indoor::PixelMap;

namespace {

struct Problem {
  PixelMap<float> values;
  PixelMap<int> labels;
  PixelMap<std::uint8_t> mask;
};

Problem
randomProblem(unsigned labels,
              unsigned seed_every,
              unsigned hole_every,
              std::mt19937& rng)
{
  const int nx = 1 + static_cast<int>(rng() % 9), ny = 1 + static_cast<int>(rng() % 9);
  Problem p{{nx, ny, {}}, {nx, ny, {}}, {nx, ny, {}}};
  for (int i = 0; i < nx * ny; ++i) {
    p.values.values.push_back(static_cast<float>(rng() % 1000) / 500.0f);
    p.labels.values.push_back(rng() % seed_every ? -1
                                                 : static_cast<int>(rng() % labels));
    p.mask.values.push_back(rng() % hole_every != 0);
  }
  return p;
}

bool
areNeighbours(const Problem& p, std::size_t i, std::size_t j)
{
  const int ny = p.values.ny;
  const int dx = std::abs(static_cast<int>(i) / ny - static_cast<int>(j) / ny);
  const int dy = std::abs(static_cast<int>(i) % ny - static_cast<int>(j) % ny);
  return i != j && p.mask.values[i] && p.mask.values[j] && dx + dy == 1;
}

double
weight(const Problem& p, std::size_t i, std::size_t j, double beta)
{
  const double d = static_cast<double>(p.values.values[i]) - p.values.values[j];
  return std::exp(-beta * d * d);
}

/** The probabilities of one label at all pixels, from one dense system. */
std::vector<double>
probabilityBruteForce(const Problem& p, int label, double beta)
{
  const std::size_t n = p.values.size();
  // L x = 0 at unlabelled pixels, x = 1 or 0 at seeds
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd side = Eigen::VectorXd::Zero(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (p.labels.values[i] >= 0 || !p.mask.values[i]) {
      system(i, i) = 1.0;
      side[i] = p.mask.values[i] && p.labels.values[i] == label;
      continue;
    }
    system(i, i) = 1e-13; // pixels that reach no seed: 0
    for (std::size_t j = 0; j < n; ++j)
      if (areNeighbours(p, i, j)) {
        system(i, i) += weight(p, i, j, beta);
        system(i, j) -= weight(p, i, j, beta);
      }
  }
  const Eigen::VectorXd x = system.fullPivLu().solve(side);
  return {x.data(), x.data() + n};
}

} // namespace

TEST(MapRandomWalker, EqualsTheDenseSolution)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 150; ++trial) {
    const unsigned labels = 1 + rng() % 4;
    const auto p = randomProblem(labels, 3 + rng() % 20, 2 + rng() % 9, rng);
    const auto beta = static_cast<double>(rng() % 4);
    const auto result = pcl::indoor::mapRandomWalker(p.values, p.labels, p.mask, beta);
    std::vector<std::vector<double>> probability;
    for (unsigned l = 0; l < labels; ++l)
      probability.push_back(probabilityBruteForce(p, static_cast<int>(l), beta));
    for (std::size_t i = 0; i < p.values.size(); ++i) {
      double best = 0.0;
      for (const auto& of_label : probability)
        best = std::max(best, of_label[i]);
      if (!p.mask.values[i] ||
          best < 0.1) { // the best of 4 is 0.25 at least, or nobody
        ASSERT_EQ(result.values[i], -1) << "trial " << trial;
        continue;
      }
      ASSERT_GE(result.values[i], 0) << "trial " << trial;
      // rounding of two solvers on up to 81 unknowns, and the tie
      ASSERT_GT(probability[static_cast<std::size_t>(result.values[i])][i], best - 1e-8)
          << "trial " << trial << ", pixel " << i;
    }
  }
}

TEST(MapRandomWalker, AgreesWithTheOneOfPCL)
{
  using Graph =
      boost::adjacency_list<boost::vecS,
                            boost::vecS,
                            boost::undirectedS,
                            boost::property<boost::vertex_color_t, std::uint32_t>,
                            boost::property<boost::edge_weight_t, float>>;
  std::mt19937 rng(2);
  for (int trial = 0; trial < 30; ++trial) {
    auto p = randomProblem(3, 6, std::numeric_limits<unsigned>::max(), rng);
    if (p.values.size() < 30)
      continue;
    p.labels.values[0] = 0;
    p.labels.values.back() = 1;
    Graph graph(p.values.size());
    for (std::size_t i = 0; i < p.values.size(); ++i) {
      boost::put(
          boost::vertex_color, graph, i, p.labels.values[i] + 1); // 0 = unlabelled
      for (std::size_t j = 0; j < i; ++j)
        if (areNeighbours(p, i, j))
          boost::add_edge(i, j, static_cast<float>(weight(p, i, j, 1.0)), graph);
    }
    ASSERT_TRUE(pcl::segmentation::randomWalker(graph));
    const auto result = pcl::indoor::mapRandomWalker(p.values, p.labels, p.mask, 1.0);
    int different = 0;
    for (std::size_t i = 0; i < p.values.size(); ++i)
      different += static_cast<int>(boost::get(boost::vertex_color, graph, i)) !=
                   result.values[i] + 1;
    EXPECT_LE(different, 1) << "trial " << trial; // theirs computes in float
  }
}

TEST(MapRandomWalker, StopsAtAStepOfTheValues)
{
  // a step between the third and the fourth of seven pixels, seeds at the ends
  const PixelMap<float> values{1, 7, {0.0f, 0.0f, 0.0f, 9.0f, 9.0f, 9.0f, 9.0f}};
  const PixelMap<int> labels{1, 7, {4, -1, -1, -1, -1, -1, 2}};
  const PixelMap<std::uint8_t> mask{1, 7, std::vector<std::uint8_t>(7, 1)};
  EXPECT_EQ(pcl::indoor::mapRandomWalker(values, labels, mask, 1.0).values,
            (std::vector<int>{4, 4, 4, 2, 2, 2, 2}));
  // without weights the middle decides; the middle pixel is a tie: the smaller label
  EXPECT_EQ(pcl::indoor::mapRandomWalker(values, labels, mask, 0.0).values,
            (std::vector<int>{4, 4, 4, 2, 2, 2, 2}));
}

TEST(MapRandomWalker, SurvivesWeightsThatVanish)
{
  constexpr std::size_t pixel_count = 120 * 120; // enough to be worth two threads
  PixelMap<float> values{120, 120, {}};
  PixelMap<int> labels{120, 120, std::vector<int>(pixel_count, -1)};
  for (std::size_t i = 0; i < pixel_count; ++i)
    values.values.push_back(static_cast<float>((i * 7919) % 1000));
  labels.values[0] = 0;
  labels.values[pixel_count - 1] = 1;
  labels.values[pixel_count / 2] = 2;
  const PixelMap<std::uint8_t> mask{
      120, 120, std::vector<std::uint8_t>(pixel_count, 1)};
  const auto one = pcl::indoor::mapRandomWalker(values, labels, mask, 1.0, 1);
  for (const int label : one.values)
    EXPECT_TRUE(label >= 0 && label <= 2);
  EXPECT_EQ(pcl::indoor::mapRandomWalker(values, labels, mask, 1.0, 8).values,
            one.values);
}

TEST(MapRandomWalker, HandlesLittleAndBadInput)
{
  EXPECT_TRUE(pcl::indoor::mapRandomWalker({}, {}, {}, 1.0).values.empty());
  PixelMap<float> values{1, 1, {1.0f}};
  PixelMap<int> labels{1, 1, {-1}};
  const PixelMap<std::uint8_t> mask{1, 1, {1}};
  EXPECT_EQ(pcl::indoor::mapRandomWalker(values, labels, mask, 1.0).values[0], -1);
  labels.values[0] = 7;
  EXPECT_EQ(pcl::indoor::mapRandomWalker(values, labels, mask, 1.0).values[0], 7);
  EXPECT_THROW(pcl::indoor::mapRandomWalker(values, {}, mask, 1.0),
               pcl::BadArgumentException);
  EXPECT_THROW(pcl::indoor::mapRandomWalker(values, labels, mask, -1.0),
               pcl::BadArgumentException);
  values.values[0] = std::numeric_limits<float>::infinity();
  EXPECT_THROW(pcl::indoor::mapRandomWalker(values, labels, mask, 1.0),
               pcl::BadArgumentException);
}
