/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/network_inference.h>

#include <c10/core/GradMode.h>
#include <gtest/gtest.h>

#include "adam.h"
#include "convolution.h"
#include "network_module.h"
#include "small_networks.h"

#include <cmath>

namespace pcl::indoor {
namespace {

using test::smallNetworks;
using test::thirds;

at::Tensor
randomTensor(const std::vector<std::int64_t>& sizes, std::uint64_t seed)
{
  auto random = at::detail::createCPUGenerator(seed);
  return at::randn(sizes, random, at::kFloat);
}

/** Zeros around: n / 2 after, the rest of n - 1 before. */
at::Tensor
naiveConvolution4D(const at::Tensor& input,
                   const at::Tensor& weights,
                   const at::Tensor& biases)
{
  auto sizes = input.sizes().vec();
  sizes[1] = weights.size(0);
  auto output = at::zeros(sizes, at::kFloat);
  const auto in = input.accessor<float, 6>();
  const auto w = weights.accessor<float, 6>();
  const auto b = biases.accessor<float, 1>();
  auto out = output.accessor<float, 6>();
  const auto inputAt = [&](std::int64_t n, std::int64_t c, const std::int64_t* p) {
    for (int k = 0; k < 4; ++k)
      if (p[k] < 0 || p[k] >= input.size(k + 2))
        return 0.0f;
    return in[n][c][p[0]][p[1]][p[2]][p[3]];
  };
  const auto kernel_count = weights[0][0].numel();
  const auto position_count = input[0][0].numel();
  for (std::int64_t n = 0; n < sizes[0]; ++n)
    for (std::int64_t o = 0; o < sizes[1]; ++o)
      for (std::int64_t position = 0; position < position_count; ++position) {
        std::int64_t p[4];
        for (std::int64_t k = 3, rest = position; k >= 0; rest /= sizes[k + 2], --k)
          p[k] = rest % sizes[k + 2];
        double sum = b[o];
        for (std::int64_t c = 0; c < input.size(1); ++c)
          for (std::int64_t element = 0; element < kernel_count; ++element) {
            std::int64_t q[4];
            std::int64_t from[4];
            for (std::int64_t k = 3, rest = element; k >= 0;
                 rest /= weights.size(k + 2), --k) {
              q[k] = rest % weights.size(k + 2);
              from[k] = p[k] + q[k] - (weights.size(k + 2) - 1) / 2;
            }
            sum += inputAt(n, c, from) * w[o][c][q[0]][q[1]][q[2]][q[3]];
          }
        out[n][o][p[0]][p[1]][p[2]][p[3]] = static_cast<float>(sum);
      }
  return output;
}

TEST(NetworkModule, Convolution4DEqualsLoops)
{
  for (const std::vector<std::int64_t>& kernel : {std::vector<std::int64_t>{5, 2, 2, 1},
                                                  {1, 1, 1, 1},
                                                  {2, 3, 4, 1},
                                                  {3, 2, 1, 2},
                                                  {1, 2, 3, 3},
                                                  {2, 2, 2, 4}}) {
    const auto input = randomTensor({3, 2, 6, 4, 5, 3}, 1);
    const auto weights =
        randomTensor({4, 2, kernel[0], kernel[1], kernel[2], kernel[3]}, 2);
    const auto biases = randomTensor({4}, 3);
    const auto expected = naiveConvolution4D(input, weights, biases);
    EXPECT_TRUE(at::allclose(convolution(input, weights, biases), expected, 0, 1e-4));
    EXPECT_TRUE(
        at::allclose(stackedConvolution4D(input, weights, biases), expected, 0, 1e-4));
  }
}

TEST(NetworkModule, FoldedAndStackedConvolutionHaveTheSameGradients)
{
  std::vector<std::vector<at::Tensor>> gradients;
  for (const auto& function : {convolution, stackedConvolution4D}) {
    const auto input = randomTensor({3, 2, 6, 4, 5, 3}, 1).requires_grad_();
    const auto weights = randomTensor({4, 2, 5, 2, 2, 1}, 2).requires_grad_();
    const auto biases = randomTensor({4}, 3).requires_grad_();
    (function(input, weights, biases).square().sum()).backward();
    gradients.push_back({input.grad(), weights.grad(), biases.grad()});
  }
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_TRUE(at::allclose(gradients[0][k], gradients[1][k], 1e-3, 1e-2)) << k;
}

at::Tensor
rows(const TrainingSet& set)
{
  std::vector<at::Tensor> all;
  for (const auto& draws : set.inputs)
    for (const auto& draw : draws)
      all.push_back(at::tensor(draw, at::kFloat));
  return at::stack(all);
}

TEST(NetworkModule, GradientsEqualFiniteDifferences)
{
  for (const auto& [name, network] : smallNetworks()) {
    const NetworkModule module(network, at::kCPU);
    const auto inputs = rows(thirds(network, 6, 3, 1));
    const auto direction_of_loss = randomTensor({6, 3}, 9);
    const auto loss = [&] {
      auto dropout = at::detail::createCPUGenerator(5);
      return (module.scores(inputs, &dropout) * direction_of_loss).sum();
    };
    loss().backward();
    const c10::NoGradGuard no_gradients;
    std::uint64_t seed = 20;
    for (const auto& parameter : module.parameters()) {
      auto values = parameter.detach();
      // along the gradient and at random
      const auto& gradient = parameter.grad();
      const auto random = randomTensor(values.sizes().vec(), ++seed);
      const auto step =
          (gradient / gradient.norm().clamp_min(1e-6) + random / random.norm()) * 1e-3;
      const double expected = (gradient * step).sum().item<double>() * 2.0;
      values.add_(step);
      const double after = loss().item<double>();
      values.sub_(step, 2.0);
      const double before = loss().item<double>();
      values.add_(step);
      EXPECT_NEAR(after - before, expected, 0.1 * std::abs(expected) + 5e-5)
          << name << ", parameter " << seed - 20;
    }
  }
}

/** \brief Move all weights, so that none is at what it starts with. */
void
disturbWeights(std::vector<Layer>& layers, std::mt19937& random)
{
  for (auto& layer : layers) {
    for (auto& weights : layer.weights)
      for (float& value : weights.values)
        value += 0.02f * static_cast<float>(random() % 10);
    disturbWeights(layer.inner, random);
  }
}

TEST(NetworkModule, ScoresEqualThoseOfInference)
{
  auto networks = smallNetworks();
  networks.push_back({"whole 4D", eppfNetwork4D(5)});
  networks.push_back({"whole 3D", eppfNetwork3D(5)});
  networks.push_back({"whole 2D", eppfNetwork2D(5)});
  networks.push_back({"wide perceptron", perceptron(5, {1200})});
  networks.push_back({"whole PointNet", pointNet(5, 64)});
  std::mt19937 random(3);
  for (auto& [name, network] : networks) {
    initializeWeights(network, 7);
    if (valueCount(network.input) < 1000) // else they would sum up to huge scores
      disturbWeights(network.layers, random);
    const auto set = thirds(network, 4, 3, 1);
    std::vector<std::vector<float>> inputs;
    for (const auto& draws : set.inputs)
      inputs.push_back(draws.front());
    const auto expected = networkScores(network, inputs);
    const c10::NoGradGuard no_gradients;
    const auto scores = NetworkModule(network, at::kCPU).scores(rows(set), nullptr);
    double largest = 1.0;
    for (const auto& of_object : expected)
      for (const float score : of_object)
        largest = std::max(largest, std::abs(static_cast<double>(score)));
    for (std::size_t object = 0; object < expected.size(); ++object)
      for (std::size_t k = 0; k < expected[object].size(); ++k)
        EXPECT_NEAR(
            scores[static_cast<std::int64_t>(object)][static_cast<std::int64_t>(k)]
                .item<double>(),
            expected[object][k],
            1e-4 * largest)
            << name;
  }
}

/** \brief Ten steps of Adam on f = sum of k (x_k - k)^2. */
TEST(Adam, EqualsItsFormulas)
{
  const double decay = 0.1;
  const double rate = 0.05;
  std::vector<double> x{1.0, -2.0, 3.0};
  std::vector<double> means(3, 0.0);
  std::vector<double> squares(3, 0.0);
  const auto values = at::tensor({1.0f, -2.0f, 3.0f}).requires_grad_();
  const auto factors = at::arange(3, at::kFloat);
  Adam adam({values}, decay);
  for (int step = 1; step <= 10; ++step) {
    (factors * (values - factors).square()).sum().backward();
    adam.step(rate);
    for (std::size_t k = 0; k < 3; ++k) {
      const double g = 2.0 * static_cast<double>(k) * (x[k] - static_cast<double>(k));
      means[k] = 0.9 * means[k] + 0.1 * g;
      squares[k] = 0.999 * squares[k] + 0.001 * g * g;
      const double mean = means[k] / (1.0 - std::pow(0.9, step));
      const double square = squares[k] / (1.0 - std::pow(0.999, step));
      x[k] -= rate * (decay * x[k] + mean / (std::sqrt(square) + 1e-8));
    }
  }
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(values[k].item<double>(), x[static_cast<std::size_t>(k)], 1e-4);
}

} // namespace
} // namespace pcl::indoor
