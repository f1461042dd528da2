/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "network_evaluation.h"

#include "row_products.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

/** \brief All objects at once: each row of the weights is read a few times only. */
void
applyDense(const Layer& layer, ObjectValues& objects)
{
  const std::size_t size = valueCount(objects.shape);
  const auto& biases = layer.weights[1].values;
  std::vector<float> inputs;
  inputs.reserve(size * objects.arrays.size());
  std::vector<float> outputs;
  outputs.reserve(biases.size() * objects.arrays.size());
  for (const auto& values : objects.arrays) {
    inputs.insert(inputs.end(), values.begin(), values.end());
    outputs.insert(outputs.end(), biases.begin(), biases.end());
  }
  addRowProducts({layer.weights[0].values.data(), biases.size()},
                 {inputs.data(), objects.arrays.size()},
                 size,
                 outputs.data(),
                 1,
                 biases.size());
  auto output = outputs.cbegin();
  for (auto& values : objects.arrays) {
    const auto end = output + static_cast<std::ptrdiff_t>(biases.size());
    values.assign(output, end);
    output = end;
  }
}

void
applyScale(const Layer& layer, std::vector<float>& values)
{
  const auto& factors = layer.weights[0].values;
  const auto& summands = layer.weights[1].values;
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = values[k] * factors[k] + summands[k];
}

void
applyBatchNorm(const Layer& layer, std::vector<float>& values)
{
  const auto& weights = layer.weights;
  const std::size_t channels = weights[0].values.size();
  const std::size_t size = values.size() / channels;
  for (std::size_t channel = 0; channel < channels; ++channel) {
    const float mean = weights[0].values[channel];
    const float offset = weights[3].values[channel];
    const float variance = weights[1].values[channel];
    const float factor = weights[2].values[channel] /
                         std::sqrt(variance + static_cast<float>(batch_norm_epsilon));
    float* const first = values.data() + channel * size;
    std::transform(first, first + size, first, [=](float value) {
      return (value - mean) * factor + offset;
    });
  }
}

std::vector<float>
maxOverPositions(const Shape& shape, const std::vector<float>& values)
{
  const auto channels = static_cast<std::size_t>(shape.front());
  const std::size_t size = values.size() / channels;
  std::vector<float> largest(channels);
  for (std::size_t channel = 0; channel < channels; ++channel) {
    const float* const first = values.data() + channel * size;
    largest[channel] = *std::max_element(first, first + size);
  }
  return largest;
}

void
applyTransform(const Layer& layer, ObjectValues& objects)
{
  auto matrices = objects;
  for (const auto& inner : layer.inner)
    applyLayer(inner, matrices);
  const auto channels = static_cast<std::size_t>(objects.shape.front());
  std::vector<float> columns(channels * channels);
  std::vector<float> positions;
  for (std::size_t object = 0; object < objects.arrays.size(); ++object) {
    auto& values = objects.arrays[object];
    const std::size_t size = values.size() / channels;
    for (std::size_t row = 0; row < channels; ++row)
      for (std::size_t column = 0; column < channels; ++column)
        columns[column * channels + row] =
            matrices.arrays[object][row * channels + column] +
            (row == column ? 1.0f : 0.0f);
    positions.resize(values.size());
    for (std::size_t channel = 0; channel < channels; ++channel)
      for (std::size_t k = 0; k < size; ++k)
        positions[k * channels + channel] = values[channel * size + k];
    std::fill(values.begin(), values.end(), 0.0f);
    addRowProducts({columns.data(), channels},
                   {positions.data(), size},
                   channels,
                   values.data(),
                   size,
                   1);
  }
}

} // namespace

void
applyLayer(const Layer& layer, ObjectValues& objects)
{
  switch (layer.kind) {
  case LayerKind::Dense:
    applyDense(layer, objects);
    break;
  case LayerKind::Transform:
    applyTransform(layer, objects);
    break;
  case LayerKind::Scale:
    for (auto& values : objects.arrays)
      applyScale(layer, values);
    break;
  case LayerKind::SquareRoot:
    for (auto& values : objects.arrays)
      for (float& value : values)
        value = value > 0.0f ? std::sqrt(value) : 0.0f;
    break;
  case LayerKind::Convolution:
    for (auto& values : objects.arrays)
      values = convolution(layer, objects.shape, values);
    break;
  case LayerKind::BatchNorm:
    for (auto& values : objects.arrays)
      applyBatchNorm(layer, values);
    break;
  case LayerKind::Relu:
    for (auto& values : objects.arrays)
      for (float& value : values)
        value = std::max(value, 0.0f);
    break;
  case LayerKind::MaxPool:
    for (auto& values : objects.arrays)
      values = maxPool(layer, objects.shape, values);
    break;
  case LayerKind::MaxOverPositions:
    for (auto& values : objects.arrays)
      values = maxOverPositions(objects.shape, values);
    break;
  case LayerKind::Reshape:
  case LayerKind::Dropout:
    break;
  }
  objects.shape = outputShape(layer, objects.shape);
}

} // namespace pcl::indoor
