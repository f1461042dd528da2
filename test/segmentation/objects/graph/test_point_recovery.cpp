/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/labelled_points.h"

#include "objects/graph/point_recovery.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::indoor;

namespace {

constexpr auto none = Supervoxels::none;

/** A chain of places 3 cm apart. */
struct Chain {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
  Adjacency neighbors;

  explicit Chain(std::uint32_t length)
  {
    neighbors.offsets.push_back(0);
    for (std::uint32_t i = 0; i < length; ++i) {
      positions.emplace_back(0.03f * static_cast<float>(i), 0, 0);
      normals.emplace_back(0, 0, 1);
      if (i > 0)
        neighbors.targets.push_back(i - 1);
      if (i + 1 < length)
        neighbors.targets.push_back(i + 1);
      neighbors.offsets.push_back(static_cast<std::uint32_t>(neighbors.targets.size()));
    }
  }
};

/** Algorithm 1 with its sort moved out of the point loop, to the letter. */
std::vector<std::uint32_t>
recoverLiterally(const Chain& chain,
                 const SurfaceDistance& distance,
                 unsigned iterations,
                 double share,
                 std::vector<std::uint32_t> labels)
{
  for (unsigned s = 0;; ++s) {
    std::vector<std::tuple<float, std::uint32_t, std::uint32_t>> w;
    for (std::uint32_t p = 0; p < labels.size(); ++p) {
      if (labels[p] != none)
        continue;
      float smallest = std::numeric_limits<float>::max();
      std::uint32_t label = none;
      for (std::uint32_t m = 0; m < labels.size(); ++m) {
        const bool touches = (p > 0 && m == p - 1) || m == p + 1;
        if (!touches || labels[m] == none)
          continue;
        const float d = distance(
            chain.positions[p], chain.normals[p], chain.positions[m], chain.normals[m]);
        if (d < smallest) {
          smallest = d;
          label = labels[m];
        }
      }
      if (label != none)
        w.emplace_back(smallest, p, label);
    }
    if (w.empty())
      return labels;
    std::sort(w.begin(), w.end());
    auto preserve = w.size();
    if (s + 1 < iterations)
      preserve = std::max<std::size_t>(1, std::lround(share * w.size()));
    for (std::size_t i = 0; i < preserve; ++i)
      labels[std::get<1>(w[i])] = std::get<2>(w[i]);
  }
}

} // namespace

TEST(PointRecovery, AgreesWithTheAlgorithm)
{
  std::mt19937 rng(5);
  std::size_t recovered = 0;
  for (int trial = 0; trial < 50; ++trial) {
    Chain chain(40);
    std::vector<std::uint32_t> labels(40, none);
    for (std::uint32_t i = 0; i < 40; ++i) {
      const float tilt = static_cast<float>(rng() % 100) / 50 - 1;
      chain.normals[i] = Eigen::Vector3f(tilt, 0, 1).normalized();
      chain.positions[i].x() += 0.0001f * static_cast<float>(rng() % 100);
      if (rng() % 6 == 0)
        labels[i] = static_cast<std::uint32_t>(rng() % 3);
    }
    auto result = labels;
    recoverLabels(chain.positions, chain.normals, chain.neighbors, {}, result);
    EXPECT_EQ(result, recoverLiterally(chain, {}, 20, 0.8, labels));
    recovered +=
        static_cast<std::size_t>(std::count(labels.begin(), labels.end(), none) -
                                 std::count(result.begin(), result.end(), none));
  }
  EXPECT_GT(recovered, 1000u);
}

TEST(PointRecovery, FollowsTheSurfaceNotOnlyTheDistance)
{
  Chain chain(3);
  chain.positions[1].x() = 0.035f;             // nearer to the right,
  chain.normals[2] = Eigen::Vector3f(1, 0, 0); // which bends away
  std::vector<std::uint32_t> labels{1, none, 2};
  recoverLabels(chain.positions, chain.normals, chain.neighbors, {}, labels);
  EXPECT_EQ(labels[1], 1u);
}

TEST(PointRecovery, ReachesPlacesFartherThanTheIterations)
{
  const Chain chain(500);
  std::vector<std::uint32_t> labels(500, none);
  labels[0] = 4;
  recoverLabels(chain.positions, chain.normals, chain.neighbors, {}, labels);
  EXPECT_EQ(labels, std::vector<std::uint32_t>(500, 4));
}

TEST(PointRecovery, PlacesWithoutLabelledNeighborsGetLabelsOfTheirOwn)
{
  Adjacency neighbors;
  neighbors.offsets = {0, 1, 2, 2, 2};
  neighbors.targets = {1, 0};
  std::vector<std::uint32_t> labels{none, none, none, 0};
  labelRemainder(neighbors, 1, labels);
  EXPECT_EQ(labels, (std::vector<std::uint32_t>{1, 1, 2, 0}));
}

TEST(PointRecovery, EmptyIsEmpty)
{
  const Chain chain(0);
  std::vector<std::uint32_t> labels;
  recoverLabels({}, {}, chain.neighbors, {}, labels);
  EXPECT_TRUE(labels.empty());
}
