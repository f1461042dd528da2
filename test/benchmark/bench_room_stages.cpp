/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "office_floor.h"
#include "rooms/space/dominant_directions.h"
#include "rooms/space/enclosure.h"
#include "rooms/space/occupancy_grid.h"
#include "rooms/space/vertical_cleanup.h"
#include "rooms/space/voxel_normals.h"
#include "rooms/storeys/storeys.h"

#include <pcl/filters/voxel_grid.h>

#include <pcl/point_types.h>

#include <benchmark/benchmark.h>

using namespace pcl::indoor;

namespace {

/** \brief A floor with as many points; 12 points per occupied voxel. */
std::vector<Eigen::Vector3f>
floorPoints(std::int64_t count)
{
  // The house has about one occupied voxel in 4.4.
  const double columns = static_cast<double>(count) / 12.0 * 4.4 / 18.0;
  const int side = std::max(30, static_cast<int>(std::sqrt(columns)));
  return pointsOf(officeFloor(side, side, 18), static_cast<std::size_t>(count));
}

OccupancyGrid
gridOf(const std::vector<Eigen::Vector3f>& points)
{
  return occupancyGrid(points);
}

void
pclVoxelGrid(benchmark::State& state) // the yardstick
{
  const auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const auto& p : floorPoints(state.range(0)))
    cloud->emplace_back(p.x(), p.y(), p.z());
  for (auto _ : state) {
    pcl::VoxelGrid<pcl::PointXYZ> filter;
    filter.setInputCloud(cloud);
    filter.setLeafSize(0.2f, 0.2f, 0.2f);
    pcl::PointCloud<pcl::PointXYZ> output;
    filter.filter(output);
    benchmark::DoNotOptimize(output.points.data());
  }
}

void
occupancy(benchmark::State& state)
{
  const auto points = floorPoints(state.range(0));
  OccupancyGridOptions options;
  options.threads = static_cast<int>(state.range(1));
  options.yaw = 0.1;
  for (auto _ : state)
    benchmark::DoNotOptimize(occupancyGrid(points, options).cells.data());
}

void
normals(benchmark::State& state)
{
  const auto points = floorPoints(state.range(0));
  const OccupancyGrid grid = gridOf(points);
  const auto threads = static_cast<int>(state.range(1));
  for (auto _ : state)
    benchmark::DoNotOptimize(voxelNormals(points, grid, threads).weights.data());
}

void
directions(benchmark::State& state)
{
  const auto points = floorPoints(state.range(0));
  const WeightedNormals found = voxelNormals(points, gridOf(points));
  for (auto _ : state)
    benchmark::DoNotOptimize(manhattanFrames(found.normals, found.weights).data());
  state.counters["normals"] = static_cast<double>(found.normals.size());
}

/** The occupied voxels as these steps have coarser ones. */
VoxelMap<std::uint8_t>
bytesOf(const VoxelBits& bits)
{
  VoxelMap<std::uint8_t> bytes{bits.shape, bits.origin, bits.voxel_size, {}};
  for (std::size_t pixel = 0; pixel < bits.columns(); ++pixel)
    for (int z = 0; z < bits.shape.nz; ++z)
      bytes.values.push_back(bits.column(pixel)[z]);
  return bytes;
}

void
cleanup(benchmark::State& state)
{
  const auto grid = bytesOf(gridOf(floorPoints(state.range(0))).grid);
  for (auto _ : state) {
    auto copy = grid;
    cleanUpVertically(copy, static_cast<int>(state.range(1)));
    benchmark::DoNotOptimize(copy.values.data());
  }
}

void
enclosureOf(benchmark::State& state)
{
  const auto grid = bytesOf(gridOf(floorPoints(state.range(0))).grid);
  for (auto _ : state)
    benchmark::DoNotOptimize(enclosure(grid,
                                       {{1.0, 0.1, 0.0}, {-0.1, 1.0, 0.0}},
                                       static_cast<int>(state.range(1)))
                                 .values.data());
  state.counters["voxels"] = static_cast<double>(grid.values.size());
}

void
storeys(benchmark::State& state)
{
  const auto grid = gridOf(floorPoints(state.range(0))).grid;
  for (auto _ : state)
    benchmark::DoNotOptimize(findStoreys(grid).heights.data());
}

void
sizes(benchmark::internal::Benchmark* benchmark)
{
  for (const int count : {10000, 100000, 1000000, 2800000})
    benchmark->Args({count, 1});
  benchmark->Unit(benchmark::kMillisecond);
}

void
sizesAndThreads(benchmark::internal::Benchmark* benchmark)
{
  sizes(benchmark);
  benchmark->Args({2800000, 2})->UseRealTime();
}

} // namespace

BENCHMARK(pclVoxelGrid)->Apply(sizes);
BENCHMARK(occupancy)->Apply(sizesAndThreads);
BENCHMARK(normals)->Apply(sizesAndThreads);
BENCHMARK(directions)->Apply(sizes);
BENCHMARK(cleanup)->Apply(sizesAndThreads);
BENCHMARK(enclosureOf)->Apply(sizesAndThreads);
BENCHMARK(storeys)->Apply(sizes);

BENCHMARK_MAIN();
