/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "floor_map.h"
#include "thesis/rooms/field_connectivity.h"
#include "thesis/rooms/map_labels.h"
#include "thesis/rooms/map_random_walker.h"
#include "thesis/rooms/potential_field.h"

#include <benchmark/benchmark.h>

namespace {

/** Labels as a clustering leaves them: the tops of the field, a third of the pixels. */
pcl::indoor::PixelMap<int>
topLabels(const FloorMap& map)
{
  const pcl::indoor::PixelMap<int> none{
      map.field.nx, map.field.ny, std::vector<int>(map.field.size(), -1)};
  auto values = map.field.values;
  std::nth_element(values.begin(),
                   values.begin() + static_cast<std::ptrdiff_t>(values.size() * 2 / 3),
                   values.end());
  return pcl::indoor::labelPeaks(none, map.field, values[values.size() * 2 / 3], 20);
}

pcl::indoor::PixelMap<std::uint8_t>
interiorMask(const FloorMap& map)
{
  pcl::indoor::PixelMap<std::uint8_t> mask{map.field.nx, map.field.ny, {}};
  for (const int height : map.heights.values)
    mask.values.push_back(height >= 0);
  return mask;
}

void
potentialField(benchmark::State& state)
{
  const FloorMap map(static_cast<int>(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(
        pcl::indoor::potentialField(map.occupancy, static_cast<int>(state.range(1))));
  state.counters["voxels"] = static_cast<double>(map.occupancy.shape.size());
}
BENCHMARK(potentialField)
    ->ArgNames({"edge", "threads"})
    ->Args({100, 1})
    ->Args({484, 1}) // 3.75 M voxels
    ->Args({484, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/** A cube of 512^3 with sparse obstacles, to compare with other distance transforms. */
void
potentialFieldCube(benchmark::State& state)
{
  pcl::indoor::VoxelMap<std::uint8_t> cube;
  cube.shape = {512, 512, 512};
  cube.values.assign(cube.shape.size(), 0);
  std::mt19937 rng(1);
  for (std::size_t k = cube.values.size() / 1000; k > 0; --k)
    cube.values[rng() % cube.values.size()] = 1;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        pcl::indoor::potentialField(cube, static_cast<int>(state.range(0))));
}
BENCHMARK(potentialFieldCube)
    ->Arg(1)
    ->Arg(2)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void
fieldConnectivity(benchmark::State& state)
{
  const FloorMap map(static_cast<int>(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(pcl::indoor::FieldConnectivity(map.field).maximum());
}
BENCHMARK(fieldConnectivity)
    ->Arg(100)
    ->Arg(316)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);

void
fieldConnectivityQuery(benchmark::State& state)
{
  const FloorMap map(316);
  const pcl::indoor::FieldConnectivity connectivity(map.field);
  std::mt19937 rng(1);
  std::vector<std::size_t> ends(4096);
  for (auto& end : ends)
    end = rng() % map.field.size();
  std::size_t k = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        connectivity.distance(ends[k % 4096], ends[(k * 7 + 1) % 4096]));
    ++k;
  }
}
BENCHMARK(fieldConnectivityQuery);

void
visibilityVectors(benchmark::State& state)
{
  const FloorMap map(static_cast<int>(state.range(0)));
  const auto landmarks = pcl::indoor::spreadLandmarks(
      map.heights, std::max(1, static_cast<int>(state.range(0)) / 16));
  for (auto _ : state)
    benchmark::DoNotOptimize(
        pcl::indoor::visibilityVectors(map.occupancy, map.highest, landmarks, 2));
  state.counters["landmarks"] = static_cast<double>(landmarks.size());
}
BENCHMARK(visibilityVectors)
    ->Arg(100)
    ->Arg(210)
    ->Arg(316)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void
randomWalker(benchmark::State& state)
{
  const FloorMap map(static_cast<int>(state.range(0)));
  const auto labels = topLabels(map);
  const auto mask = interiorMask(map);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        pcl::indoor::mapRandomWalker(map.field, labels, mask, 0.01, 2));
}
BENCHMARK(randomWalker)
    ->Arg(100)
    ->Arg(316)
    ->Arg(632)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void
labelVoxels(benchmark::State& state)
{
  const FloorMap map(static_cast<int>(state.range(0)));
  const auto labels =
      pcl::indoor::mapRandomWalker(map.field, topLabels(map), interiorMask(map), 1.0);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        pcl::indoor::labelVoxels(map.occupancy, map.interior, labels, 2));
  state.counters["voxels"] = static_cast<double>(map.occupancy.shape.size());
}
BENCHMARK(labelVoxels)
    ->Arg(100)
    ->Arg(484)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace

BENCHMARK_MAIN();
