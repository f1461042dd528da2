/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "floor_map.h"
#include "thesis/rooms/map_clustering.h"

#include <pcl/segmentation/hdbscan.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <fstream>
#include <string>

namespace {

/** The largest memory of the process so far, MB. */
double
peakMemory()
{
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
    if (word == "VmHWM:") {
      double kilobytes = 0.0;
      status >> kilobytes;
      return kilobytes / 1024.0;
    }
  return 0.0;
}

pcl::indoor::HDBSCANOptions
mapOptions(int threads)
{
  pcl::indoor::HDBSCANOptions options;
  options.min_cluster_size = 100;
  options.min_samples = 10;
  options.threads = threads;
  return options;
}

pcl::indoor::MapDistance
mapDistance(const FloorMap& map)
{
  const int spacing = std::max(1, map.field.nx / 16); // about 256 landmarks
  return {map.field.nx,
          map.field.ny,
          map.pixels,
          pcl::indoor::FieldConnectivity(map.field),
          pcl::indoor::visibilityVectors(
              map.occupancy,
              map.highest,
              pcl::indoor::spreadLandmarks(map.heights, spacing)),
          {}};
}

/** Eq. (3.4) of a map of edge x edge pixels, the structure exploited. */
void
clusterMap(benchmark::State& state)
{
  const FloorMap map(static_cast<int>(state.range(0)));
  const auto distance = mapDistance(map);
  const auto options = mapOptions(static_cast<int>(state.range(1)));
  std::size_t clusters = 0;
  for (auto _ : state)
    clusters = pcl::indoor::clusterMap(distance, options).stabilities.size();
  state.counters["pixels"] = static_cast<double>(distance.size());
  state.counters["clusters"] = static_cast<double>(clusters);
  state.counters["peak_MB"] = peakMemory();
}
BENCHMARK(clusterMap)
    ->ArgNames({"edge", "threads"})
    ->Args({105, 1})
    ->Args({210, 1})
    ->Args({210, 2})
    ->Args({420, 2})
    ->Args({840, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/** The same from all pairs. */
void
clusterMapDense(benchmark::State& state)
{
  const FloorMap map(static_cast<int>(state.range(0)));
  const auto distance = mapDistance(map);
  const auto options = mapOptions(static_cast<int>(state.range(1)));
  for (auto _ : state)
    benchmark::DoNotOptimize(pcl::indoor::hdbscan(distance.size(), distance, options));
  state.counters["pixels"] = static_cast<double>(distance.size());
  state.counters["peak_MB"] = peakMemory();
}
BENCHMARK(clusterMapDense)
    ->ArgNames({"edge", "threads"})
    ->Args({105, 1})
    ->Args({210, 2})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->UseRealTime();

/** Points in the plane, all pairs. */
void
hdbscanDense(benchmark::State& state)
{
  std::mt19937 rng(1);
  std::vector<double> x, y;
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    x.push_back(static_cast<double>(rng() % 30 * 40 + rng() % 20));
    y.push_back(static_cast<double>(rng() % 1000) / 50.0);
  }
  const auto distance = [&](std::size_t i, std::size_t j) {
    return std::sqrt((x[i] - x[j]) * (x[i] - x[j]) + (y[i] - y[j]) * (y[i] - y[j]));
  };
  for (auto _ : state)
    benchmark::DoNotOptimize(pcl::indoor::hdbscan(x.size(), distance, mapOptions(2)));
  state.counters["peak_MB"] = peakMemory();
}
BENCHMARK(hdbscanDense)
    ->Arg(5000)
    ->Arg(20000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->UseRealTime();

/** Neighbouring pixels as a graph, edges weighted by the steps of the field. */
void
hdbscanGraph(benchmark::State& state)
{
  const FloorMap map(static_cast<int>(state.range(0)));
  std::vector<pcl::indoor::HDBSCANEdge> edges;
  const auto& field = map.field;
  for (int x = 0; x + 1 < field.nx; ++x)
    for (int y = 0; y + 1 < field.ny; ++y)
      for (const auto& [u, v] : {std::pair{x + 1, y}, {x, y + 1}, {x + 1, y + 1}}) {
        const double low = std::min(field.at(x, y), field.at(u, v));
        edges.push_back({static_cast<std::uint32_t>(field.index(x, y)),
                         static_cast<std::uint32_t>(field.index(u, v)),
                         1.0 / (1.0 + low)});
      }
  auto options = mapOptions(1);
  options.min_samples = 1;
  for (auto _ : state)
    benchmark::DoNotOptimize(pcl::indoor::hdbscan(field.size(), edges, options));
  state.counters["pixels"] = static_cast<double>(field.size());
  state.counters["peak_MB"] = peakMemory();
}
BENCHMARK(hdbscanGraph)
    ->Arg(100)
    ->Arg(316)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace

BENCHMARK_MAIN();
