/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// bench_classification MODEL FOLDER: describe and name every .pcd of a folder and the
// folders in it (points with normals) in one batch on one thread. One iteration is all
// objects; "per_object" is its time over their number.
#include <pcl/io/pcd_io.h>
#include <pcl/ml/model_file.h>
#include <pcl/ml/object_classifier.h>
#include <pcl/point_types.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace {

std::vector<pcl::indoor::ClassifierObject>
loadObjects(const std::string& folder)
{
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".pcd")
      paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  std::vector<pcl::indoor::ClassifierObject> objects;
  for (const auto& path : paths) {
    pcl::PointCloud<pcl::PointNormal> cloud;
    if (pcl::io::loadPCDFile(path, cloud) != 0)
      continue;
    objects.emplace_back();
    for (const auto& point : cloud)
      objects.back().points.push_back(
          {point.getVector3fMap(), point.getNormalVector3fMap()});
  }
  return objects;
}

void
classification(benchmark::State& state,
               const pcl::indoor::ClassifierModel& model,
               const std::vector<pcl::indoor::ClassifierObject>& objects)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(pcl::indoor::classifyObjects(objects, model, 1).size());
  state.counters["per_object"] =
      benchmark::Counter(static_cast<double>(state.iterations() * objects.size()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

} // namespace

int
main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  if (argc != 3) {
    std::fprintf(stderr, "Syntax is: bench_classification MODEL FOLDER\n");
    return EXIT_FAILURE;
  }
  const auto model = pcl::indoor::loadModel(argv[1]);
  const auto objects = loadObjects(argv[2]);
  if (objects.empty()) {
    std::fprintf(stderr, "%s: no .pcd file\n", argv[2]);
    return EXIT_FAILURE;
  }
  benchmark::RegisterBenchmark("classification", classification, model, objects)
      ->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
}
