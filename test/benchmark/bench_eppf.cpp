/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// bench_eppf [FOLDER]: pair harmonics and EPPF beside pcl::ESFEstimation on every .pcd
// of a folder and the folders in it (points with normals), or on boxes of 2,048 points
// without one. One iteration describes one object. Reference: 8 ms per object for EPPF
// in the thesis.
#include <pcl/console/print.h>
#include <pcl/features/eppf.h>
#include <pcl/features/esf.h>
#include <pcl/features/surflet_pair.h>
#include <pcl/io/pcd_io.h>
#include <pcl/ml/histogram_distance.h>

#include <benchmark/benchmark.h>

#include "features/oriented_shapes.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using Cloud = pcl::PointCloud<pcl::PointNormal>;

std::vector<Cloud::Ptr>&
objects()
{
  static std::vector<Cloud::Ptr> all;
  return all;
}

void
loadObjects(const std::string& folder)
{
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".pcd")
      paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  for (const auto& path : paths) {
    auto cloud = pcl::make_shared<Cloud>();
    if (pcl::io::loadPCDFile(path, *cloud) == 0)
      objects().push_back(cloud);
  }
}

void
makeObjects()
{
  for (std::uint32_t k = 0; k < 50; ++k) {
    auto cloud = pcl::make_shared<Cloud>();
    const Eigen::Vector3f size(1.0f, 0.1f + 0.1f * static_cast<float>(k % 7), 0.5f);
    for (const auto& point : pcl::indoor::boxSurface(size, 2048, k)) {
      cloud->emplace_back();
      cloud->back().getVector3fMap() = point.position;
      cloud->back().getNormalVector3fMap() = point.normal;
    }
    objects().push_back(cloud);
  }
}

template <typename Estimation, typename Signature>
void
describeInTurn(benchmark::State& state, Estimation& estimation)
{
  std::size_t k = 0;
  for (auto _ : state) {
    const auto& object = objects()[k++ % objects().size()];
    estimation.setInputCloud(object);
    estimation.setInputNormals(object);
    pcl::PointCloud<Signature> descriptor;
    estimation.compute(descriptor);
    benchmark::DoNotOptimize(descriptor.size());
  }
}

template <typename Signature>
void
eppf(benchmark::State& state)
{
  pcl::EPPFEstimation<pcl::PointNormal, pcl::PointNormal, Signature> estimation;
  estimation.setNumberOfThreads(static_cast<unsigned int>(state.range(0)));
  describeInTurn<decltype(estimation), Signature>(state, estimation);
}

void
surfletPair(benchmark::State& state)
{
  pcl::SurfletPairEstimation<pcl::PointNormal, pcl::PointNormal> estimation;
  describeInTurn<decltype(estimation), pcl::SurfletPairSignature625>(state, estimation);
}

void
esf(benchmark::State& state)
{
  std::size_t k = 0;
  for (auto _ : state) {
    pcl::ESFEstimation<pcl::PointNormal, pcl::ESFSignature640> estimation;
    estimation.setInputCloud(objects()[k++ % objects().size()]);
    pcl::PointCloud<pcl::ESFSignature640> descriptor;
    estimation.compute(descriptor);
    benchmark::DoNotOptimize(descriptor.size());
  }
}

/** \brief All pairs of 568 descriptors. */
void
allDistances(benchmark::State& state, pcl::indoor::HistogramDistance distance)
{
  using Signature = pcl::PairHarmonicsSignature1200;
  pcl::EPPFEstimation<pcl::PointNormal, pcl::PointNormal, Signature> estimation;
  pcl::indoor::Histograms histograms;
  for (std::uint32_t k = 0; k < 568; ++k) {
    const auto& object = objects()[k % objects().size()];
    estimation.setInputCloud(object);
    estimation.setInputNormals(object);
    estimation.setSeed(k);
    pcl::PointCloud<Signature> descriptor;
    estimation.compute(descriptor);
    histograms.emplace_back(descriptor[0].histogram, descriptor[0].histogram + 1200);
  }
  for (auto _ : state)
    benchmark::DoNotOptimize(
        pcl::indoor::histogramDistances(histograms, histograms, distance));
}

} // namespace

int
main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); // files without curvature
  if (argc > 1)
    loadObjects(argv[1]);
  else
    makeObjects();
  if (objects().empty())
    return EXIT_FAILURE;
  const auto all_objects = static_cast<benchmark::IterationCount>(objects().size());
  benchmark::RegisterBenchmark("pair_harmonics", eppf<pcl::PairHarmonicsSignature1200>)
      ->Arg(1)
      ->Arg(2)
      ->Iterations(all_objects)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("eppf", eppf<pcl::EPPFSignature1200>)
      ->Arg(1)
      ->Arg(2)
      ->Iterations(all_objects)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("surflet_pair", surfletPair)
      ->Iterations(all_objects)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("esf", esf)
      ->Iterations(all_objects)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("all_distances_kl",
                               allDistances,
                               pcl::indoor::HistogramDistance::SymmetricKullbackLeibler)
      ->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
