/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/ml/network_designs.h>

#include <ATen/Parallel.h>
#include <benchmark/benchmark.h>
#include <torch/optim/adamw.h>

#include "adam.h"
#include "convolution.h"
#include "network_module.h"
#include "training_resources.h"

#include <thread>

namespace {

constexpr int class_count = 13;
constexpr std::int64_t batch_size = 64;

pcl::indoor::NetworkModule
networkModule()
{
  auto network = pcl::indoor::eppfNetwork4D(class_count);
  pcl::indoor::initializeWeights(network, 1);
  return {network, at::kCPU};
}

at::Tensor
batchLabels()
{
  return at::arange(batch_size, at::kLong).remainder(class_count);
}

/** A step as trainNetwork() takes it. */
void
BM_TrainingStep(benchmark::State& state)
{
  const pcl::indoor::TrainingResources resources(static_cast<int>(state.range(0)));
  const auto module = networkModule();
  pcl::indoor::Adam adam(module.parameters(), 0.0);
  const auto inputs = at::rand({batch_size, 1200});
  const auto labels = batchLabels();
  auto dropout = at::detail::createCPUGenerator(1);
  for (auto _ : state) {
    at::cross_entropy_loss(module.scores(inputs, &dropout), labels).backward();
    adam.step(5e-4);
  }
}

/** The same network as one would write it: a stacked 4D convolution, and libtorch's own
 * layers and optimizer; with the second argument 1, our dense layer instead of its. */
void
BM_PlainTrainingStep(benchmark::State& state)
{
  at::set_num_threads(static_cast<int>(state.range(0)));
  const bool has_our_product = state.range(1) != 0;
  const auto w = networkModule().parameters();
  torch::optim::AdamW adam(w, torch::optim::AdamWOptions(5e-4).weight_decay(0.0));
  const auto inputs = at::rand({batch_size, 1, 20, 4, 5, 3});
  const auto labels = batchLabels();
  const auto dense = [&](const at::Tensor& values, std::size_t k) {
    return has_our_product ? pcl::indoor::denseLayer(values, w[k], w[k + 1])
                           : at::linear(values, w[k], w[k + 1]);
  };
  for (auto _ : state) {
    auto x = pcl::indoor::stackedConvolution4D(inputs, w[0], w[1]).relu();
    x = pcl::indoor::stackedConvolution4D(x, w[2], w[3]).relu();
    x = at::conv2d(x.reshape({batch_size, 64, 40, 30}), w[4], w[5], 1, 2).relu();
    x = at::dropout(dense(at::max_pool2d(x, 2).flatten(1), 6).relu(), 0.5, true);
    adam.zero_grad();
    at::cross_entropy_loss(dense(x, 8), labels).backward();
    adam.step();
  }
}

void
threadCounts(benchmark::internal::Benchmark* benchmark, const std::vector<int>& other)
{
  for (const int value : other)
    for (const int threads : {1, static_cast<int>(std::thread::hardware_concurrency())})
      benchmark->Args({threads, value});
  benchmark->Unit(benchmark::kMillisecond)->UseRealTime();
}

/** What a part of the step costs, forwards and backwards. */
void
measure(benchmark::State& state,
        std::vector<at::Tensor> arguments,
        at::Tensor (*function)(const at::Tensor&, const at::Tensor&, const at::Tensor&))
{
  const pcl::indoor::TrainingResources resources(static_cast<int>(state.range(0)));
  for (auto& argument : arguments)
    argument.set_requires_grad(argument.dim() < 6 || argument.size(1) > 1);
  for (auto _ : state) {
    const auto result = function(arguments[0], arguments[1], arguments[2]);
    result.backward(at::ones_like(result));
    for (auto& argument : arguments)
      argument.mutable_grad().reset();
  }
}

void
BM_Convolution4D(benchmark::State& state)
{
  const auto in = state.range(1);
  measure(state,
          {at::rand({batch_size, in, 20, 4, 5, 3}),
           at::rand({in == 1 ? 32 : 64, in, 5, 2, 2, 1}),
           at::rand({in == 1 ? 32 : 64})},
          pcl::indoor::convolution);
}

void
BM_StackedConvolution4D(benchmark::State& state)
{
  const auto in = state.range(1);
  measure(state,
          {at::rand({batch_size, in, 20, 4, 5, 3}),
           at::rand({in == 1 ? 32 : 64, in, 5, 2, 2, 1}),
           at::rand({in == 1 ? 32 : 64})},
          pcl::indoor::stackedConvolution4D);
}

void
BM_Convolution2D(benchmark::State& state)
{
  measure(
      state,
      {at::rand({batch_size, 64, 40, 30}), at::rand({48, 64, 5, 5}), at::rand({48})},
      pcl::indoor::convolution);
}

void
BM_Dense(benchmark::State& state)
{
  measure(state,
          {at::rand({batch_size, 14400}), at::rand({1024, 14400}), at::rand({1024})},
          pcl::indoor::denseLayer);
}

void
BM_Adam(benchmark::State& state)
{
  const pcl::indoor::TrainingResources resources(static_cast<int>(state.range(0)));
  const auto module = networkModule();
  pcl::indoor::Adam adam(module.parameters(), 0.0);
  for (auto _ : state) {
    for (auto parameter : module.parameters())
      parameter.mutable_grad() = parameter.detach();
    adam.step(1e-9);
  }
}

} // namespace

BENCHMARK(BM_TrainingStep)->Apply([](auto* b) { threadCounts(b, {0}); });
BENCHMARK(BM_PlainTrainingStep)->Apply([](auto* b) { threadCounts(b, {0, 1}); });
BENCHMARK(BM_Convolution4D)->Apply([](auto* b) { threadCounts(b, {1, 32}); });
BENCHMARK(BM_StackedConvolution4D)->Apply([](auto* b) { threadCounts(b, {1, 32}); });
BENCHMARK(BM_Convolution2D)->Apply([](auto* b) { threadCounts(b, {0}); });
BENCHMARK(BM_Dense)->Apply([](auto* b) { threadCounts(b, {0}); });
BENCHMARK(BM_Adam)->Apply([](auto* b) { threadCounts(b, {0}); });
BENCHMARK_MAIN();
