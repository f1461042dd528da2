/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/grid_cut.h>

#include "support/boost_grid_cut.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

using namespace pcl::indoor;

namespace {

struct Problem {
  GridShape shape;
  std::vector<std::int16_t> gain;
  int smoothness = 0;
};

Problem
randomProblem(std::mt19937& rng, int largest, int max_gain, int max_smoothness)
{
  Problem problem;
  const auto side = [&] { return 1 + static_cast<int>(rng() % largest); };
  problem.shape = {side(), side(), side()};
  problem.smoothness = static_cast<int>(rng() % (max_smoothness + 1));
  const unsigned excluded = rng() % 3;
  for (std::size_t v = 0; v < problem.shape.size(); ++v)
    problem.gain.push_back(
        rng() % 5 < excluded
            ? GRID_CUT_EXCLUDED
            : static_cast<std::int16_t>(static_cast<int>(rng() % (2 * max_gain + 1)) -
                                        max_gain));
  return problem;
}

/** \brief Large connected regions with contradictory evidence, as in buildings: many
 * long paths.
 */
Problem
blobProblem(std::mt19937& rng)
{
  Problem problem = randomProblem(rng, 14, 3, 6);
  const GridShape& shape = problem.shape;
  for (int blob = 0; blob < 6; ++blob) {
    const int cx = rng() % shape.nx;
    const int cy = rng() % shape.ny;
    const int cz = rng() % shape.nz;
    const int radius = 1 + rng() % 5;
    const int value = static_cast<int>(rng() % 9) - 4;
    for (int x = std::max(0, cx - radius); x < std::min(shape.nx, cx + radius); ++x)
      for (int y = std::max(0, cy - radius); y < std::min(shape.ny, cy + radius); ++y)
        for (int z = std::max(0, cz - radius); z < std::min(shape.nz, cz + radius); ++z)
          problem.gain[shape.index(x, y, z)] = static_cast<std::int16_t>(value);
  }
  return problem;
}

void
expectSameAsBoost(const Problem& problem, int trial)
{
  const GridCut ours = cutGrid(problem.shape, problem.gain, problem.smoothness);
  const GridCut boosts = boostGridCut(problem.shape, problem.gain, problem.smoothness);
  EXPECT_EQ(ours.energy, boosts.energy) << "trial " << trial;
  EXPECT_EQ(ours.inside, boosts.inside) << "trial " << trial;
  EXPECT_EQ(gridCutEnergy(problem.shape, problem.gain, problem.smoothness, ours.inside),
            ours.energy)
      << "trial " << trial;
}

} // namespace

TEST(CutGrid, EqualsAllLabellingsTried)
{
  std::mt19937 rng(11);
  for (int trial = 0; trial < 100; ++trial) {
    Problem problem = randomProblem(rng, 3, 5, 4);
    problem.shape = {2, 1 + trial % 2, 3};
    problem.gain.resize(problem.shape.size(), 2);
    std::int64_t best = std::numeric_limits<std::int64_t>::max();
    for (unsigned labels = 0; labels < 1u << problem.gain.size(); ++labels) {
      std::vector<std::uint8_t> inside;
      for (std::size_t v = 0; v < problem.gain.size(); ++v)
        inside.push_back(labels >> v & 1);
      best = std::min(
          best, gridCutEnergy(problem.shape, problem.gain, problem.smoothness, inside));
    }
    const GridCut cut = cutGrid(problem.shape, problem.gain, problem.smoothness);
    EXPECT_EQ(cut.energy, best) << "trial " << trial;
  }
}

TEST(CutGrid, SameEnergyAndSmallestInsideAsBoostOnRandomGrids)
{
  std::mt19937 rng(12);
  for (int trial = 0; trial < 300; ++trial)
    expectSameAsBoost(randomProblem(rng, 9, 1 + rng() % 20, 1 + rng() % 10), trial);
}

TEST(CutGrid, SameEnergyAndSmallestInsideAsBoostOnBlobs)
{
  std::mt19937 rng(13);
  for (int trial = 0; trial < 200; ++trial)
    expectSameAsBoost(blobProblem(rng), trial);
}

TEST(CutGrid, SameAsBoostAtTheLimitsOfTheRange)
{
  std::mt19937 rng(14);
  for (int trial = 0; trial < 30; ++trial) {
    Problem problem = randomProblem(rng, 8, GRID_CUT_MAX_GAIN, 1);
    problem.smoothness = GRID_CUT_MAX_SMOOTHNESS;
    expectSameAsBoost(problem, trial);
  }
}

TEST(CutGrid, EmptyOneVoxelAndAllExcluded)
{
  EXPECT_TRUE(cutGrid({0, 5, 5}, {}, 3).inside.empty());
  EXPECT_EQ(cutGrid({1, 1, 1}, {1}, 3).inside[0], 1);
  EXPECT_EQ(cutGrid({1, 1, 1}, {0}, 3).inside[0], 0); // a tie goes outside
  EXPECT_EQ(cutGrid({1, 1, 1}, {-1}, 3).inside[0], 0);
  EXPECT_EQ(cutGrid({1, 1, 2}, {GRID_CUT_EXCLUDED, GRID_CUT_EXCLUDED}, 3).energy, 0);
}

TEST(CutGrid, RefusesBadArguments)
{
  EXPECT_THROW(cutGrid({1, 1, 2}, {1}, 3), pcl::BadArgumentException);
  EXPECT_THROW(cutGrid({1, 1, 1}, {1}, -1), pcl::BadArgumentException);
  EXPECT_THROW(cutGrid({1, 1, 1}, {1}, GRID_CUT_MAX_SMOOTHNESS + 1),
               pcl::BadArgumentException);
  EXPECT_THROW(gridCutEnergy({1, 1, 1}, {1}, 1, {}), pcl::BadArgumentException);
}
