/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

// How time and memory of the room segmentation grow with the area of the building:
//   bench_room_growth [options of Google Benchmark] scan.pcd
// The scan is laid out 1, 2 x 2, 4 x 4 and 8 x 8 times, with a metre between the
// copies. MiB: the largest memory of the process while segmenting, the cloud itself
// included (Linux only, otherwise 0).

#include <pcl/common/common.h> // for getMinMax3D
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/room_segmentation.h>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr
tiled(const Cloud& cloud, int tiles)
{
  Eigen::Vector4f low, high;
  pcl::getMinMax3D(cloud, low, high);
  const Eigen::Vector3f step = (high - low).head<3>().array() + 1.0f;
  Cloud::Ptr result(new Cloud);
  result->points.reserve(cloud.size() * tiles * tiles);
  for (int i = 0; i < tiles; ++i)
    for (int j = 0; j < tiles; ++j)
      for (const auto& point : cloud)
        result->points.emplace_back(
            point.x + i * step.x(), point.y + j * step.y(), point.z);
  result->width = static_cast<std::uint32_t>(result->points.size());
  result->height = 1;
  return result;
}

/** \brief The largest memory of this process since the last call, in MiB. */
double
peakMemory()
{
  std::ifstream status("/proc/self/status");
  double kibibytes = 0.0;
  for (std::string word; status >> word;)
    if (word == "VmHWM:")
      status >> kibibytes;
  std::ofstream("/proc/self/clear_refs") << "5"; // begin anew
  return kibibytes / 1024.0;
}

void
roomGrowth(benchmark::State& state, const Cloud& scan)
{
  const Cloud::Ptr cloud = tiled(scan, static_cast<int>(state.range(0)));
  std::size_t rooms = 0;
  peakMemory();
  for (auto _ : state) {
    pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
    segmentation.setNumberOfThreads(2);
    segmentation.setInputCloud(cloud);
    std::vector<std::uint32_t> labels;
    segmentation.segment(labels);
    rooms = segmentation.getRooms().size();
  }
  state.counters["MiB"] = peakMemory();
  state.counters["points"] = static_cast<double>(cloud->size());
  state.counters["rooms"] = static_cast<double>(rooms);
}

} // namespace

int
main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  Cloud scan;
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], scan) != 0) {
    std::cerr << "Syntax is: bench_room_growth scan.pcd\n";
    return EXIT_FAILURE;
  }
  benchmark::RegisterBenchmark(
      "room_growth", [&scan](benchmark::State& state) { roomGrowth(state, scan); })
      ->ArgName("tiles_per_side")
      ->RangeMultiplier(2)
      ->Range(1, 8)
      ->Iterations(1)
      ->UseRealTime()
      ->Unit(benchmark::kSecond);
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
