/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/ml/network_designs.h>
#include <pcl/ml/network_training.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor {
namespace test {

inline Layer
layer(LayerKind kind, const Shape& extents = {}, float rate = 0.0f)
{
  return {kind, extents, rate};
}

/** \brief Small networks with the layers of the designs, and those that none has. */
inline std::vector<std::pair<std::string, Network>>
smallNetworks()
{
  using Kind = LayerKind;
  const auto withEnd = [](Network network) {
    for (const auto& last : {layer(Kind::Dense, {16}),
                             layer(Kind::Relu),
                             layer(Kind::Dropout, {}, 0.2f),
                             layer(Kind::Dense, {3})})
      network.layers.push_back(last);
    return network;
  };
  std::vector<std::pair<std::string, Network>> networks;
  networks.push_back({"4D",
                      withEnd({{1, 6, 2, 3, 2},
                               {layer(Kind::Convolution, {4, 5, 2, 2, 1}),
                                layer(Kind::Relu),
                                layer(Kind::Convolution, {6, 5, 2, 2, 1}),
                                layer(Kind::Relu),
                                layer(Kind::Reshape, {6, 12, 6}),
                                layer(Kind::Convolution, {4, 5, 5}),
                                layer(Kind::Relu),
                                layer(Kind::MaxPool, {2, 2})}})});
  networks.push_back({"3D",
                      withEnd({{1, 6, 4, 5},
                               {layer(Kind::Convolution, {4, 5, 5, 1}),
                                layer(Kind::Relu),
                                layer(Kind::MaxPool, {2, 2, 2})}})});
  networks.push_back({"2D",
                      withEnd({{1, 12, 10},
                               {layer(Kind::Convolution, {4, 5, 5}),
                                layer(Kind::Relu),
                                layer(Kind::MaxPool, {2, 2})}})});
  networks.push_back({"stacked",
                      withEnd({{2, 4, 3, 3, 5},
                               {layer(Kind::Convolution, {4, 3, 2, 1, 2}),
                                layer(Kind::BatchNorm),
                                layer(Kind::MaxPool, {2, 1, 1, 2})}})});
  networks.push_back({"1D",
                      withEnd({{2, 11},
                               {layer(Kind::Convolution, {4, 4}),
                                layer(Kind::MaxPool, {3}),
                                layer(Kind::SquareRoot)}})});
  networks.push_back({"perceptron", perceptron(3, {20, {16, 8}, 0.2f})});
  networks.push_back({"PointNet", pointNet(3, 24, 1.0 / 16.0)});
  for (auto& [name, network] : networks)
    initializeWeights(network, 7);
  return networks;
}

/** \brief Noise, with classes that differ in which third of the values is larger. */
inline TrainingSet
thirds(const Network& network,
       int object_count,
       std::uint32_t seed,
       std::size_t draws = 2)
{
  std::mt19937 random(seed);
  TrainingSet set;
  const auto count = valueCount(network.input);
  for (int object = 0; object < object_count; ++object) {
    set.labels.push_back(object % 3);
    set.inputs.emplace_back();
    for (std::size_t draw = 0; draw < draws; ++draw) {
      std::vector<float> values;
      for (std::size_t k = 0; k < count; ++k)
        values.push_back(static_cast<float>(random() % 1000) / 1000.0f +
                         (static_cast<int>(3 * k / count) == object % 3 ? 0.5f : 0.0f));
      set.inputs.back().push_back(std::move(values));
    }
  }
  return set;
}

} // namespace test
} // namespace pcl::indoor
