/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "office_floor.h"
#include "support/boost_grid_cut.h"

#include <pcl/segmentation/enclosure.h>
#include <pcl/segmentation/grid_cut.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl::indoor;

namespace {

struct Problem {
  GridShape shape;
  std::vector<std::int16_t> gain;
};

/** \brief The problem of the room segmentation; about this many voxels. */
Problem
interiorProblem(std::int64_t voxels)
{
  const int nz = 20;
  const auto columns = static_cast<double>(voxels) / nz;
  const int nx = std::max(30, static_cast<int>(std::sqrt(columns / 0.75)));
  const int ny = std::max(30, static_cast<int>(columns / nx));
  const auto grid = officeFloor(nx, ny, nz);
  const auto bits = enclosure(grid, {{1, 0}, {0, 1}});
  return {grid.shape, interiorGain(grid, bits, 2)};
}

/** \brief Independent gains: long paths everywhere, the worst case. */
Problem
randomProblem(std::int64_t voxels)
{
  const int nx = static_cast<int>(std::cbrt(static_cast<double>(voxels)));
  Problem problem;
  problem.shape = {nx, nx, nx};
  std::mt19937 rng(63);
  for (std::size_t v = 0; v < problem.shape.size(); ++v)
    problem.gain.push_back(
        static_cast<std::int16_t>(static_cast<int>(rng() % 401) - 200));
  return problem;
}

template <typename Solver>
void
run(benchmark::State& state, const Problem& problem, Solver solver)
{
  std::int64_t energy = 0;
  for (auto _ : state)
    energy = solver(problem.shape, problem.gain, 60).energy;
  state.counters["voxels"] = static_cast<double>(problem.gain.size());
  state.counters["energy"] = static_cast<double>(energy);
}

void
gridCutInterior(benchmark::State& state)
{
  run(state, interiorProblem(state.range(0)), cutGrid);
}

void
gridCutRandom(benchmark::State& state)
{
  run(state, randomProblem(state.range(0)), cutGrid);
}

void
boostInterior(benchmark::State& state)
{
  run(state, interiorProblem(state.range(0)), boostGridCut);
}

void
boostRandom(benchmark::State& state)
{
  run(state, randomProblem(state.range(0)), boostGridCut);
}

} // namespace

BENCHMARK(gridCutInterior)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Arg(3750000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(boostInterior)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Arg(3750000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(gridCutRandom)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Arg(3750000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(boostRandom)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Arg(3750000)
    ->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
