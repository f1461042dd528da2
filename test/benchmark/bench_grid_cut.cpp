/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "office_floor.h"
#include "rooms/space/enclosure.h"
#include "rooms/space/grid_cut.h"
#include "support/boost_grid_cut.h"
#include "support/hard_cuts.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

using namespace pcl::indoor;

namespace {

/** \brief What is missing in a scan of an office floor. */
enum class Missing { Nothing, Ceiling, Floor };

/** \brief The problem of the room segmentation; about this many voxels. */
CutProblem
office(std::int64_t voxels, Missing missing = Missing::Nothing)
{
  const int nz = 20;
  const auto columns = static_cast<double>(voxels) / nz;
  const int nx = std::max(30, static_cast<int>(std::sqrt(columns / 0.75)));
  const int ny = std::max(30, static_cast<int>(columns / nx));
  auto grid = officeFloor(nx, ny, nz);
  for (std::size_t v = 0; v < grid.values.size(); ++v) {
    const int z = static_cast<int>(v % nz);
    if ((missing == Missing::Ceiling && z > 11) || (missing == Missing::Floor && z < 4))
      grid.values[v] = 0;
  }
  const auto coded = interiorGain(grid, enclosure(grid, {{1, 0, 0}, {0, 1, 0}}), 2);
  CutProblem problem{grid.shape, {}, 60};
  for (std::size_t v = 0; v < coded.codes.size(); ++v)
    problem.gain.push_back(coded[v]);
  return problem;
}

using Solver = GridCut (*)(const GridShape&, const std::vector<std::int16_t>&, int);
using Make = std::function<CutProblem(std::int64_t)>;

void
measure(benchmark::State& state, const Make& make, Solver solver)
{
  const CutProblem problem = make(state.range(0));
  std::int64_t energy = 0;
  for (auto _ : state)
    energy = solver(problem.shape, problem.gain, problem.smoothness).energy;
  const auto active =
      std::count_if(problem.gain.begin(), problem.gain.end(), [](std::int16_t gain) {
        return gain != GRID_CUT_EXCLUDED;
      });
  state.counters["voxels"] = static_cast<double>(problem.gain.size());
  state.counters["active"] = static_cast<double>(active);
  state.counters["energy"] = static_cast<double>(energy);
  state.counters["s_per_voxel"] = benchmark::Counter(
      static_cast<double>(problem.gain.size()),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void
add(const std::string& name, const Make& make, const std::vector<std::int64_t>& boosts)
{
  const auto enter = [&](const std::string& who, Solver solver) {
    return benchmark::RegisterBenchmark((who + "/" + name).c_str(),
                                        [make, solver](benchmark::State& state) {
                                          measure(state, make, solver);
                                        })
        ->Unit(benchmark::kMillisecond);
  };
  for (const std::int64_t voxels : {10000, 100000, 1000000, 3750000})
    enter("gridCut", cutGrid)->Arg(voxels);
  for (const std::int64_t voxels : boosts)
    enter("boost", boostGridCut)->Arg(voxels);
}

/** \brief A hard problem; Boost's solver takes minutes where there are many voxels. */
template <typename Problem>
void
addHard(const std::string& name, Problem problem, int nz = 0)
{
  const auto make = [=](std::int64_t voxels) {
    const auto size = static_cast<double>(voxels);
    return problem(static_cast<int>(
        std::lround(nz == 0 ? std::cbrt(size) : std::sqrt(size / nz))));
  };
  add(name, make, {10000, 100000});
}

void
addAll()
{
  namespace hard = hard_cuts;
  const std::vector<std::int64_t> all = {10000, 100000, 1000000, 3750000};
  add(
      "office", [](std::int64_t n) { return office(n); }, all);
  add(
      "officeNoCeiling", [](auto n) { return office(n, Missing::Ceiling); }, all);
  add(
      "officeNoFloor", [](auto n) { return office(n, Missing::Floor); }, all);
  addHard("uniform50", [](int n) { return hard::uniform(n, 50); });
  addHard("uniform200", [](int n) { return hard::uniform(n, 200); });
  addHard("uniform300", [](int n) { return hard::uniform(n, 300); });
  addHard("critical", [](int n) { return hard::critical(n); });
  addHard("smooth3", [](int n) { return hard::smooth(n, 3, 30.0); });
  addHard("smooth8", [](int n) { return hard::smooth(n, 8, 10.0); });
  addHard("smooth20", [](int n) { return hard::smooth(n, 20, 10.0); });
  addHard("corridorOfPieces", hard::corridorOfPieces);
  addHard("corridorOfChance", hard::corridorOfChance);
  addHard("halves", [](int n) { return hard::halves(n, 1, 1); });
  addHard("farApart", [](int n) { return hard::farApart(n, 200); });
  addHard(
      "hall", [](int n) { return hard::hall(n, -1); }, 20);
  addHard(
      "undecidedHall", [](int n) { return hard::hall(n, 0); }, 20);
  addHard("shells1", [](int n) { return hard::shells(n, 1, 50); });
  addHard("shells30", [](int n) { return hard::shells(n, 30, 4); });
  addHard("checkerboard", [](int n) { return hard::checkerboard(n, 20, 15); });
  addHard("comb", hard::comb, 20);
  addHard("maze", hard::maze);
}

} // namespace

int
main(int argc, char** argv)
{
  addAll();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
