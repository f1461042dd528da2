/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/grid_cut.h"

#include "support/boost_grid_cut.h"
#include "support/hard_cuts.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

using namespace pcl::indoor;

namespace {

using Problem = CutProblem;

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

/** \brief The energy of a labelling; see cutGrid(). */
std::int64_t
energyOf(const Problem& problem, const std::vector<std::uint8_t>& inside)
{
  const GridShape& shape = problem.shape;
  const auto& gain = problem.gain;
  const std::size_t y_step = shape.nz;
  const std::size_t x_step = y_step * shape.ny;
  const auto differ = [&](std::size_t a, std::size_t b) {
    return gain[a] != GRID_CUT_EXCLUDED && gain[b] != GRID_CUT_EXCLUDED &&
           (inside[a] != 0) != (inside[b] != 0);
  };
  std::int64_t unary = 0;
  std::int64_t pairs = 0;
  std::size_t v = 0;
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y)
      for (int z = 0; z < shape.nz; ++z, ++v) {
        if (gain[v] != GRID_CUT_EXCLUDED && (gain[v] > 0) != (inside[v] != 0))
          unary += std::abs(static_cast<int>(gain[v]));
        pairs += x > 0 && differ(v, v - x_step);
        pairs += y > 0 && differ(v, v - y_step);
        pairs += z > 0 && differ(v, v - 1);
      }
  return unary + pairs * problem.smoothness;
}

void
expectSameAsBoost(const Problem& problem, int trial)
{
  const GridCut ours = cutGrid(problem.shape, problem.gain, problem.smoothness);
  const GridCut boosts = boostGridCut(problem.shape, problem.gain, problem.smoothness);
  EXPECT_EQ(ours.energy, boosts.energy) << "trial " << trial;
  EXPECT_EQ(ours.inside, boosts.inside) << "trial " << trial;
  EXPECT_EQ(energyOf(problem, ours.inside), ours.energy) << "trial " << trial;
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
      best = std::min(best, energyOf(problem, inside));
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
    Problem problem = randomProblem(rng, 8, grid_cut_max_gain, 1);
    problem.smoothness = grid_cut_max_smoothness;
    expectSameAsBoost(problem, trial);
  }
}

TEST(CutGrid, SameAsBoostWhereWiderNumbersBegin)
{
  // Up to these, 8 bits hold a flow and 16 bits a gain and six flows.
  constexpr int smoothness = 127, gain = 32767 - 6 * smoothness;
  std::mt19937 rng(16);
  for (int trial = 0; trial < 30; ++trial) {
    Problem problem = randomProblem(rng, 6, gain, 1);
    problem.smoothness = smoothness + trial % 3 - 1;
    for (auto& value : problem.gain) // all flow to or from the same voxels
      value = value == GRID_CUT_EXCLUDED ? value
              : rng() % 7 == 0           ? gain
                                         : static_cast<std::int16_t>(value % 400);
    problem.gain[0] = static_cast<std::int16_t>(gain + trial % 2);
    expectSameAsBoost(problem, trial);
  }
}

TEST(CutGrid, AVoxelHoldsItsGainAndAllThatFlowsToIt)
{
  // Five neighbours of the middle push to it what then goes on to the sixth; or what
  // is missing goes that way.
  for (const int sign : {1, -1})
    for (const int smoothness : {127, 128})
      for (const int gain : {32005, 32006, 32200, 32640, 32767}) {
        Problem problem{{3, 3, 3}, std::vector<std::int16_t>(27, GRID_CUT_EXCLUDED)};
        problem.smoothness = smoothness;
        for (const int neighbour : {4, 10, 12, 14, 16})
          problem.gain[neighbour] = static_cast<std::int16_t>(sign * 400);
        problem.gain[13] = static_cast<std::int16_t>(sign * (gain - 1));
        problem.gain[22] = static_cast<std::int16_t>(-sign * gain);
        expectSameAsBoost(problem, gain);
      }
}

TEST(CutGrid, SameWithAByteForEachVoxel)
{
  std::mt19937 rng(17);
  for (int trial = 0; trial < 30; ++trial) {
    Problem problem = randomProblem(rng, 9, 1, 60);
    CodedGains coded;
    for (auto& gain : coded.gain_of)
      gain = static_cast<std::int16_t>(static_cast<int>(rng() % 701) - 350);
    coded.gain_of[rng() % 256] = GRID_CUT_EXCLUDED;
    for (std::size_t v = 0; v < problem.gain.size(); ++v) {
      coded.codes.push_back(static_cast<std::uint8_t>(rng() % 256));
      problem.gain[v] = coded[v];
    }
    const auto cut = cutGrid(problem.shape, coded, problem.smoothness);
    const auto same = cutGrid(problem.shape, problem.gain, problem.smoothness);
    EXPECT_EQ(cut.energy, same.energy) << "trial " << trial;
    EXPECT_EQ(cut.inside, same.inside) << "trial " << trial;
  }
}

TEST(CutGrid, SameAsBoostOnHardProblems)
{
  namespace hard = hard_cuts;
  int trial = 0;
  for (const int side : {3, 8, 13, 22})
    for (const Problem& problem : {hard::uniform(side, 200),
                                   hard::uniform(side, 1, 1),
                                   hard::critical(side),
                                   hard::smooth(side, 1, 30.0),
                                   hard::smooth(side, 4, 10.0),
                                   hard::corridorOfPieces(side),
                                   hard::corridorOfChance(side),
                                   hard::halves(side, 1, 1),
                                   hard::halves(side, 5, 4),
                                   hard::halves(side, 2, 1, 3),
                                   hard::farApart(side, 200),
                                   hard::hall(side, 0),
                                   hard::hall(side, -1),
                                   hard::shells(side, 1, 50),
                                   hard::shells(side, 3, 20),
                                   hard::checkerboard(side, 1, 200),
                                   hard::checkerboard(side, 5, 20),
                                   hard::comb(side),
                                   hard::maze(side)})
      expectSameAsBoost(problem, trial++);
}

TEST(CutGrid, SameAsBoostOnThinGridsAlongEachAxis)
{
  std::mt19937 rng(15);
  for (int trial = 0; trial < 120; ++trial) {
    Problem problem = randomProblem(rng, 1, 20, 1);
    const int a = 1 + static_cast<int>(rng() % 40);
    const int b = trial % 2 == 0 ? 1 : 1 + static_cast<int>(rng() % 9);
    problem.shape = trial % 3 == 0   ? pcl::indoor::GridShape{a, b, 1}
                    : trial % 3 == 1 ? pcl::indoor::GridShape{1, a, b}
                                     : pcl::indoor::GridShape{b, 1, a};
    problem.smoothness = static_cast<int>(rng() % 25);
    problem.gain.clear();
    for (std::size_t v = 0; v < problem.shape.size(); ++v)
      problem.gain.push_back(
          static_cast<std::int16_t>(static_cast<int>(rng() % 41) - 20));
    expectSameAsBoost(problem, trial);
  }
}

TEST(CutGrid, TiesGoOutsideAlsoAcrossManyVoxels)
{
  // 64 voxels with 3 each pay for the 6 * 16 pairs with 2 each: a tie.
  const auto cube = [](int gain) {
    return hard_cuts::fill({12, 12, 12}, 2, [&](int x, int y, int z) {
      const auto within = [](int c) { return c >= 3 && c < 7; };
      return within(x) && within(y) && within(z) ? gain : -100;
    });
  };
  const auto count = [](const Problem& problem) {
    const GridCut cut = cutGrid(problem.shape, problem.gain, problem.smoothness);
    return std::count(cut.inside.begin(), cut.inside.end(), 1);
  };
  EXPECT_EQ(count(cube(3)), 0);
  EXPECT_EQ(count(cube(4)), 64);
  EXPECT_EQ(count(hard_cuts::halves(12, 0, 0)), 0);
  EXPECT_EQ(count(hard_cuts::farApart(12, 60)), 0);
  EXPECT_EQ(count(hard_cuts::farApart(12, 61)), 144);
}

TEST(CutGrid, WithoutSmoothnessEachVoxelDecidesForItself)
{
  const Problem problem = hard_cuts::uniform(9, 2, 0);
  const GridCut cut = cutGrid(problem.shape, problem.gain, 0);
  EXPECT_EQ(cut.energy, 0);
  for (std::size_t v = 0; v < problem.gain.size(); ++v)
    EXPECT_EQ(cut.inside[v] != 0, problem.gain[v] > 0);
}

TEST(CutGrid, EmptyOneVoxelAndAllExcluded)
{
  EXPECT_TRUE(cutGrid({0, 5, 5}, CodedGains(), 3).inside.empty());
  EXPECT_EQ(cutGrid({1, 1, 1}, {1}, 3).inside[0], 1);
  EXPECT_EQ(cutGrid({1, 1, 1}, {0}, 3).inside[0], 0); // a tie goes outside
  EXPECT_EQ(cutGrid({1, 1, 1}, {-1}, 3).inside[0], 0);
  EXPECT_EQ(cutGrid({1, 1, 2}, {GRID_CUT_EXCLUDED, GRID_CUT_EXCLUDED}, 3).energy, 0);
}

TEST(CutGrid, RefusesBadArguments)
{
  EXPECT_THROW(cutGrid({1, 1, 2}, {1}, 3), pcl::BadArgumentException);
  EXPECT_THROW(cutGrid({1, 1, 1}, {1}, -1), pcl::BadArgumentException);
  EXPECT_THROW(cutGrid({1, 1, 1}, {1}, grid_cut_max_smoothness + 1),
               pcl::BadArgumentException);
  EXPECT_THROW(cutGrid({1, 1, 2}, CodedGains{{0}, {}}, 3), pcl::BadArgumentException);
}
