/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/random_draw.h>
#include <pcl/simulation/range_sensor.h>
#include <pcl/simulation/trajectory.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>

namespace {

using namespace pcl::indoor;

const Building&
office()
{
  static const Building building =
      buildBuilding(readPlan(PCL_INDOOR_PLANS "/office.json"));
  return building;
}

void
traceRandomRays(benchmark::State& state)
{
  const RayTracer tracer(office().triangles);
  const auto positions = planTrajectory(office(), {});
  RandomDraw draw(1);
  std::int64_t rays = 0;
  for (auto _ : state)
    for (const auto& position : positions) {
      const double z = draw.uniform(-1, 1), angle = draw.uniform(0, 2 * M_PI);
      const double radius = std::sqrt(1 - z * z);
      const Eigen::Vector3d direction(
          radius * std::cos(angle), radius * std::sin(angle), z);
      benchmark::DoNotOptimize(
          tracer.trace(position.cast<float>(), direction.cast<float>()));
      ++rays;
    }
  state.SetItemsProcessed(rays);
}
BENCHMARK(traceRandomRays)->Unit(benchmark::kMicrosecond);

void
buildHierarchy(benchmark::State& state)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(RayTracer(office().triangles));
}
BENCHMARK(buildHierarchy)->Unit(benchmark::kMillisecond);

void
scanOffice(benchmark::State& state)
{
  const auto positions = planTrajectory(office(), {});
  RangeSensorOptions options;
  options.rays_per_pose = static_cast<int>(state.range(0));
  options.threads = 1;
  std::size_t rays = 0;
  for (auto _ : state)
    rays += scanBuilding(office(), positions, options).ray_count;
  state.SetItemsProcessed(static_cast<std::int64_t>(rays));
}
BENCHMARK(scanOffice)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
