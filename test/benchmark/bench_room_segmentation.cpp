/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

// Room segmentation beside pcl::VoxelGrid at 0.2 m, which touches every point once:
//   bench_room_segmentation [options of Google Benchmark] scan.pcd ...
// The last column of room_segmentation is its time over that of the voxel grid,
// measured in turns within the same loop.

#include <pcl/filters/voxel_grid.h>
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/room_segmentation.h>

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

double
secondsOf(const std::function<void()>& work)
{
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
      .count();
}

void
roomSegmentation(benchmark::State& state, const Cloud::ConstPtr& cloud)
{
  double grid_seconds = 0.0, room_seconds = 0.0;
  std::size_t rooms = 0;
  for (auto _ : state) {
    grid_seconds += secondsOf([&] {
      pcl::VoxelGrid<pcl::PointXYZ> grid;
      grid.setLeafSize(0.2f, 0.2f, 0.2f);
      grid.setInputCloud(cloud);
      Cloud thinned;
      grid.filter(thinned);
      benchmark::DoNotOptimize(thinned.size());
    });
    const double seconds = secondsOf([&] {
      pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
      segmentation.setNumberOfThreads(static_cast<int>(state.range(0)));
      segmentation.setInputCloud(cloud);
      std::vector<std::uint32_t> labels;
      segmentation.segment(labels);
      rooms = segmentation.getRooms().size();
    });
    room_seconds += seconds;
    state.SetIterationTime(seconds);
  }
  state.counters["points"] = static_cast<double>(cloud->size());
  state.counters["rooms"] = static_cast<double>(rooms);
  state.counters["over_voxel_grid"] = room_seconds / grid_seconds;
}

} // namespace

int
main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  for (int i = 1; i < argc; ++i) {
    Cloud::Ptr cloud(new Cloud);
    if (pcl::io::loadPCDFile(argv[i], *cloud) != 0)
      return EXIT_FAILURE;
    benchmark::RegisterBenchmark(
        (std::string("room_segmentation/") + argv[i]).c_str(),
        [cloud](benchmark::State& state) { roomSegmentation(state, cloud); })
        ->ArgName("threads")
        ->Arg(1)
        ->Arg(2)
        ->Iterations(5)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
  if (argc < 2) {
    std::cerr << "Syntax is: bench_room_segmentation scan.pcd ...\n";
    return EXIT_FAILURE;
  }
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
