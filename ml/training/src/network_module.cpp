/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "network_module.h"

#include "convolution.h"

#include <algorithm>

namespace pcl::indoor {

namespace {

std::vector<std::int64_t>
sizes(std::int64_t first, const Shape& shape)
{
  std::vector<std::int64_t> result{first};
  result.insert(result.end(), shape.begin(), shape.end());
  return result;
}

at::Tensor
fromWeights(const Tensor& weights, const at::Device& device)
{
  auto tensor =
      at::empty(std::vector<std::int64_t>(weights.shape.begin(), weights.shape.end()),
                at::kFloat);
  std::copy(weights.values.begin(), weights.values.end(), tensor.data_ptr<float>());
  return tensor.to(device);
}

/** \brief Root of each value; derivative 0 instead of infinity where it is 0. */
at::Tensor
squareRoot(const at::Tensor& values)
{
  const auto positive = values > 0;
  return at::where(positive, values, 1.0f).sqrt() * positive;
}

/** \brief The largest value of each window along the last extent. */
at::Tensor
pooledAlongLast(const at::Tensor& values, std::int64_t window)
{
  const auto count = values.size(-1) / window;
  const auto windows =
      values.narrow(-1, 0, count * window).unflatten(-1, {count, window});
  return std::get<0>(windows.max(-1));
}

at::Tensor
maxPool(const at::Tensor& values, const Shape& window)
{
  const std::vector<std::int64_t> extents(window.begin(), window.end());
  switch (extents.size()) {
  case 0:
    return values;
  case 1:
    return pooledAlongLast(values, extents[0]);
  case 2:
    return at::max_pool2d(values, extents);
  case 3:
    return at::max_pool3d(values, extents);
  default: { // the last extent into the channels, the others by max_pool3d
    const auto last = pooledAlongLast(values, extents[3]);
    const auto folded = last.movedim(5, 2).flatten(1, 2);
    const auto pooled = at::max_pool3d(folded, at::IntArrayRef(extents).slice(0, 3));
    return pooled.unflatten(1, {values.size(1), last.size(5)}).movedim(2, 5);
  }
  }
}

/** \brief Row vectors of channels times each object's matrix (objects, in, out). */
at::Tensor
transformed(const at::Tensor& values, const at::Tensor& matrices)
{
  const auto identity = at::eye(matrices.size(1), matrices.options());
  const auto columns = (matrices + identity).transpose(1, 2);
  return at::bmm(columns, values.flatten(2)).view_as(values);
}

at::Tensor
droppedOut(const at::Tensor& values, double rate, at::Generator* random)
{
  auto kept = at::empty(values.sizes(), at::kFloat);
  kept.bernoulli_(1.0 - rate, *random).div_(1.0 - rate);
  return values * kept.to(values.device());
}

} // namespace

NetworkModule::NetworkModule(const Network& network, const at::Device& device)
: network_(network)
, weights_(load(network.layers, device))
{}

std::vector<NetworkModule::Weights>
NetworkModule::load(const std::vector<Layer>& layers, const at::Device& device)
{
  std::vector<Weights> result;
  for (const auto& layer : layers) {
    Weights weights;
    for (std::size_t k = 0; k < layer.weights.size(); ++k) {
      weights.own.push_back(fromWeights(layer.weights[k], device));
      const bool is_trained = layer.kind != LayerKind::Scale &&
                              (layer.kind != LayerKind::BatchNorm || k >= 2);
      if (is_trained)
        parameters_.push_back(weights.own.back().set_requires_grad(true));
    }
    weights.inner = load(layer.inner, device);
    result.push_back(std::move(weights));
  }
  return result;
}

at::Tensor
NetworkModule::scores(const at::Tensor& inputs, at::Generator* dropout) const
{
  const auto values = inputs.view(sizes(inputs.size(0), network_.input));
  return apply(network_.layers, weights_, values, dropout);
}

at::Tensor
NetworkModule::apply(const std::vector<Layer>& layers,
                     const std::vector<Weights>& weights,
                     at::Tensor values,
                     at::Generator* dropout) const
{
  for (std::size_t k = 0; k < layers.size(); ++k)
    values = apply(layers[k], weights[k], values, dropout);
  return values;
}

at::Tensor
NetworkModule::apply(const Layer& layer,
                     const Weights& weights,
                     const at::Tensor& values,
                     at::Generator* dropout) const
{
  const auto& own = weights.own;
  switch (layer.kind) {
  case LayerKind::Scale:
    return values * own[0] + own[1];
  case LayerKind::SquareRoot:
    return squareRoot(values);
  case LayerKind::Reshape:
    return values.reshape(sizes(values.size(0), layer.extents));
  case LayerKind::Dense:
    return denseLayer(values, own[0], own[1]);
  case LayerKind::Convolution:
    return convolution(values, own[0], own[1]);
  case LayerKind::BatchNorm:
    return at::batch_norm(values,
                          own[2],
                          own[3],
                          own[0],
                          own[1],
                          dropout != nullptr,
                          0.1,
                          batch_norm_epsilon,
                          false);
  case LayerKind::Relu:
    return values.relu();
  case LayerKind::MaxPool:
    return maxPool(values, layer.extents);
  case LayerKind::MaxOverPositions:
    return values.dim() == 2 ? values : std::get<0>(values.flatten(2).max(2));
  case LayerKind::Transform: {
    const auto matrices = apply(layer.inner, weights.inner, values, dropout);
    const auto channels = values.size(1);
    return transformed(values, matrices.reshape({-1, channels, channels}));
  }
  case LayerKind::Dropout:
    return dropout == nullptr ? values : droppedOut(values, layer.rate, dropout);
  }
  return values;
}

Network
NetworkModule::network() const
{
  Network result = network_;
  store(result.layers, weights_);
  return result;
}

void
NetworkModule::store(std::vector<Layer>& layers, const std::vector<Weights>& weights)
{
  for (std::size_t k = 0; k < layers.size(); ++k) {
    for (std::size_t w = 0; w < weights[k].own.size(); ++w) {
      const auto tensor = weights[k].own[w].detach().to(at::kCPU).contiguous();
      const auto* first = tensor.data_ptr<float>();
      layers[k].weights[w].values.assign(first, first + tensor.numel());
    }
    store(layers[k].inner, weights[k].inner);
  }
}

} // namespace pcl::indoor
