/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/network.h>

#include <pcl/exceptions.h>
#include <pcl/indoor/plain_message.h>
#include <pcl/indoor/require_valid.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <sstream>

namespace pcl::indoor {

namespace {

constexpr std::size_t most_values = std::size_t(1) << 28; // of one array

std::string
text(const Shape& shape)
{
  std::ostringstream stream;
  for (std::size_t k = 0; k < shape.size(); ++k)
    stream << (k == 0 ? "" : " x ") << shape[k];
  return "(" + stream.str() + ")";
}

[[noreturn]] void
doesNotFit(const std::string& what, const Shape& input)
{
  PCL_THROW_EXCEPTION(BadArgumentException,
                      what << " does not fit an input of shape " << text(input));
}

/** \brief Whether all extents are positive and the array is not huge. */
bool
isShape(const Shape& shape)
{
  std::size_t count = 1;
  for (const int extent : shape) {
    if (extent < 1 || static_cast<std::size_t>(extent) > most_values / count)
      return false;
    count *= static_cast<std::size_t>(extent);
  }
  return !shape.empty();
}

/** \brief The square matrix of a Transform has as many values as channels squared. */
void
requireMatrix(const Layer& layer, const Shape& input)
{
  const Shape shape = outputShape(layer.inner, input);
  const auto channels = static_cast<std::size_t>(input.front());
  if (valueCount(shape) != channels * channels)
    doesNotFit("a transform whose layers make " + text(shape), input);
}

Shape
pooledShape(const Layer& layer, const Shape& input)
{
  if (layer.extents.size() + 1 != input.size())
    doesNotFit("a pooling window of " + text(layer.extents), input);
  Shape output = input;
  for (std::size_t k = 1; k < input.size(); ++k) {
    output[k] /= layer.extents[k - 1];
    if (output[k] < 1)
      doesNotFit("a pooling window of " + text(layer.extents), input);
  }
  return output;
}

/** \brief A normal draw within two deviations, by the polar method: the same for every
 * standard library. */
float
truncatedNormal(std::mt19937& random, double deviation)
{
  const auto uniform = [&random] { return 2.0 * random() / 4294967295.0 - 1.0; };
  for (;;) {
    const double u = uniform();
    const double v = uniform();
    const double square = u * u + v * v;
    if (!(square > 0.0 && square < 1.0))
      continue;
    const double value = u * std::sqrt(-2.0 * std::log(square) / square);
    if (std::abs(value) <= 2.0)
      return static_cast<float>(deviation * value);
  }
}

/** \brief A weight and a bias of Dense and Convolution. */
void
drawWeights(Layer& layer, std::mt19937& random)
{
  auto& weights = layer.weights[0];
  const double inputs = static_cast<double>(weights.values.size()) /
                        static_cast<double>(weights.shape.front());
  // Cutting off at two deviations leaves 0.774 of the variance.
  const double deviation = std::sqrt(2.0 / inputs / 0.774);
  for (float& value : weights.values)
    value = truncatedNormal(random, deviation);
  std::fill(layer.weights[1].values.begin(), layer.weights[1].values.end(), 0.1f);
}

void
initializeLayers(std::vector<Layer>& layers, Shape shape, std::mt19937& random)
{
  for (auto& layer : layers) {
    const auto shapes = weightShapes(layer, shape);
    if (layer.weights.empty() && !shapes.empty()) {
      for (const auto& own : shapes)
        layer.weights.push_back({own, std::vector<float>(valueCount(own), 0.0f)});
      const auto ones = [&layer](std::size_t k) {
        auto& values = layer.weights[k].values;
        std::fill(values.begin(), values.end(), 1.0f);
      };
      if (layer.kind == LayerKind::Scale)
        ones(0);
      else if (layer.kind == LayerKind::BatchNorm) {
        ones(1); // variance
        ones(2); // gain
      }
      else
        drawWeights(layer, random);
    }
    if (layer.kind == LayerKind::Transform && !layer.inner.empty()) {
      auto& last = layer.inner.back();
      const bool is_new = last.weights.empty();
      initializeLayers(layer.inner, shape, random);
      if (is_new && last.kind == LayerKind::Dense)
        for (auto& tensor : last.weights)
          std::fill(tensor.values.begin(), tensor.values.end(), 0.0f);
    }
    shape = outputShape(layer, shape);
  }
}

/** \brief What is wrong with the weights of layers that fit their input. */
std::string
wrongWeights(const std::vector<Layer>& layers, Shape shape)
{
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const auto& layer = layers[k];
    const auto shapes = weightShapes(layer, shape);
    const std::string name = "layer " + std::to_string(k + 1);
    if (layer.weights.size() != shapes.size())
      return name + " has " + std::to_string(layer.weights.size()) +
             " arrays of weights, not " + std::to_string(shapes.size());
    for (std::size_t w = 0; w < shapes.size(); ++w) {
      const auto& [own, values] = layer.weights[w];
      if (own != shapes[w] || values.size() != valueCount(shapes[w]))
        return name + " has weights of shape " + text(own) + ", not " + text(shapes[w]);
      if (!std::all_of(values.begin(), values.end(), [](float value) {
            return std::isfinite(value);
          }))
        return name + " has weights that are not finite";
    }
    if (layer.kind == LayerKind::BatchNorm) {
      const auto& variances = layer.weights[1].values;
      if (*std::min_element(variances.begin(), variances.end()) < 0.0f)
        return name + " has negative variances";
    }
    const auto inner = wrongWeights(layer.inner, shape);
    if (!inner.empty())
      return name + ", " + inner;
    shape = outputShape(layer, shape);
  }
  return "";
}

std::size_t
trainedValueCount(const std::vector<Layer>& layers)
{
  std::size_t count = 0;
  for (const auto& layer : layers) {
    if (layer.kind != LayerKind::Scale)
      for (const auto& weights : layer.weights)
        count += weights.values.size();
    count += trainedValueCount(layer.inner);
  }
  return count;
}

} // namespace

std::size_t
valueCount(const Shape& shape)
{
  std::size_t count = 1;
  for (const int extent : shape)
    count *= static_cast<std::size_t>(extent);
  return count;
}

Shape
outputShape(const Layer& layer, const Shape& input)
{
  if (!isShape(input))
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "an input of shape " << text(input) << " has no values");
  switch (layer.kind) {
  case LayerKind::Scale:
  case LayerKind::SquareRoot:
  case LayerKind::BatchNorm:
  case LayerKind::Relu:
    return input;
  case LayerKind::Dropout:
    if (!(layer.rate >= 0.0f && layer.rate < 1.0f))
      PCL_THROW_EXCEPTION(BadArgumentException,
                          "The rate of dropout must be in 0 ... 1, not " << layer.rate);
    return input;
  case LayerKind::MaxOverPositions:
    return {input.front()};
  case LayerKind::Transform:
    requireMatrix(layer, input);
    return input;
  default:
    break;
  }
  if (!isShape(layer.extents))
    doesNotFit("a layer with extents " + text(layer.extents), input);
  switch (layer.kind) {
  case LayerKind::Reshape:
    if (valueCount(layer.extents) != valueCount(input))
      doesNotFit("a new shape of " + text(layer.extents), input);
    return layer.extents;
  case LayerKind::Dense:
    return {layer.extents.front()};
  case LayerKind::MaxPool:
    return pooledShape(layer, input);
  default: // Convolution
    if (layer.extents.size() != input.size() || input.size() > 5)
      doesNotFit("a convolution of " + text(layer.extents), input);
    Shape output = input;
    output.front() = layer.extents.front();
    if (!isShape(output))
      doesNotFit("a convolution of " + text(layer.extents), input);
    return output;
  }
}

Shape
outputShape(const std::vector<Layer>& layers, const Shape& input)
{
  Shape shape = input;
  for (const auto& layer : layers)
    shape = outputShape(layer, shape);
  return shape;
}

std::vector<Shape>
weightShapes(const Layer& layer, const Shape& input)
{
  const Shape output = outputShape(layer, input);
  switch (layer.kind) {
  case LayerKind::Scale:
    return {input, input};
  case LayerKind::Dense:
    return {{output.front(), static_cast<int>(valueCount(input))}, {output.front()}};
  case LayerKind::Convolution: {
    Shape weights = layer.extents;
    weights.insert(weights.begin() + 1, input.front());
    if (!isShape(weights))
      doesNotFit("a convolution of " + text(layer.extents), input);
    return {weights, {output.front()}};
  }
  case LayerKind::BatchNorm:
    return std::vector<Shape>(4, Shape{input.front()});
  default:
    return {};
  }
}

std::string
findProblem(const Network& network, bool wants_weights)
{
  if (network.layers.empty())
    return "a network needs at least one layer";
  try {
    const Shape shape = outputShape(network.layers, network.input);
    if (shape.size() != 1)
      return "a network must end with one score per class, not with shape " +
             text(shape);
    return wants_weights ? wrongWeights(network.layers, network.input) : "";
  } catch (const BadArgumentException& problem) {
    return plainMessage(problem);
  }
}

void
initializeWeights(Network& network, std::uint32_t seed)
{
  requireValid(network, false);
  std::mt19937 random(seed);
  initializeLayers(network.layers, network.input, random);
}

std::size_t
trainedValueCount(const Network& network)
{
  return trainedValueCount(network.layers);
}

} // namespace pcl::indoor
