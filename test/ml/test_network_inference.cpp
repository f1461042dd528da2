/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/exceptions.h>
#include <pcl/ml/network_designs.h>
#include <pcl/ml/network_inference.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pcl::indoor {
namespace {

using Values = std::vector<float>;

Values
randomValues(std::size_t count, std::uint32_t seed)
{
  std::mt19937 random(seed);
  Values values(count);
  for (float& value : values)
    value = static_cast<float>(random() % 2001) / 1000.0f - 1.0f;
  return values;
}

/** A network of one layer with random weights, and what makes scores of its output. */
Network
oneLayer(const Layer& layer, const Shape& input)
{
  Network network{input, {layer}};
  const auto count = valueCount(outputShape(layer, input));
  if (outputShape(layer, input).size() != 1)
    network.layers.push_back({LayerKind::Reshape, {static_cast<int>(count)}});
  std::uint32_t seed = 100;
  for (const auto& shape : weightShapes(layer, input))
    network.layers[0].weights.push_back(
        {shape, randomValues(valueCount(shape), seed++)});
  return network;
}

std::size_t
placeOf(const Shape& index, const Shape& shape)
{
  std::size_t place = 0;
  for (std::size_t k = 0; k < shape.size(); ++k)
    place =
        place * static_cast<std::size_t>(shape[k]) + static_cast<std::size_t>(index[k]);
  return place;
}

/** All indices of an array, the last one fastest. */
std::vector<Shape>
indicesOf(const Shape& shape)
{
  std::vector<Shape> indices;
  for (std::size_t place = 0; place < valueCount(shape); ++place) {
    Shape index(shape.size());
    std::size_t rest = place;
    for (std::size_t k = shape.size(); k-- > 0;) {
      index[k] = static_cast<int>(rest % static_cast<std::size_t>(shape[k]));
      rest /= static_cast<std::size_t>(shape[k]);
    }
    indices.push_back(index);
  }
  return indices;
}

Values
naiveConvolution(const Layer& layer, const Shape& input, const Values& values)
{
  Shape output = input;
  output[0] = layer.extents[0];
  Shape window = layer.extents;
  window[0] = input[0];
  Values result;
  for (const auto& to : indicesOf(output)) {
    double sum = layer.weights[1].values[static_cast<std::size_t>(to[0])];
    for (const auto& step : indicesOf(window)) {
      Shape from = step; // channel of the input
      bool is_inside = true;
      for (std::size_t k = 1; k < input.size(); ++k) {
        from[k] = to[k] + step[k] - (window[k] - 1) / 2;
        is_inside = is_inside && from[k] >= 0 && from[k] < input[k];
      }
      Shape weight = step;
      weight.insert(weight.begin(), to[0]);
      if (is_inside)
        sum +=
            double(layer.weights[0].values[placeOf(weight, layer.weights[0].shape)]) *
            values[placeOf(from, input)];
    }
    result.push_back(static_cast<float>(sum));
  }
  return result;
}

void
expectNear(const Values& found, const Values& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k)
    EXPECT_NEAR(found[k], expected[k], 1e-4f * (1.0f + std::abs(expected[k]))) << k;
}

struct ConvolutionCase {
  Shape input;
  Shape extents;
};

class Convolutions : public testing::TestWithParam<ConvolutionCase> {};

TEST_P(Convolutions, AreAsLoopsSay)
{
  const auto& [input, extents] = GetParam();
  const auto network = oneLayer({LayerKind::Convolution, extents}, input);
  const auto values = randomValues(valueCount(input), 7);
  expectNear(networkScores(network, {values})[0],
             naiveConvolution(network.layers[0], input, values));
}

INSTANTIATE_TEST_SUITE_P(
    Inference,
    Convolutions,
    testing::Values(ConvolutionCase{{2, 9}, {3, 4}},
                    ConvolutionCase{{3, 7}, {5, 1}},
                    ConvolutionCase{{1, 3}, {2, 8}}, // wider than the input
                    ConvolutionCase{{2, 6, 5}, {4, 3, 2}},
                    ConvolutionCase{{5, 4, 7}, {3, 5, 5}},
                    ConvolutionCase{{2, 5, 3, 4}, {3, 5, 2, 1}},
                    ConvolutionCase{{1, 6, 4, 5, 3}, {7, 5, 2, 2, 1}},
                    ConvolutionCase{{70, 4, 3, 2, 2}, {5, 3, 4, 3, 2}}, // sums of parts
                    ConvolutionCase{{1, 1, 1, 1, 1}, {1, 2, 2, 2, 2}}));

/** The zeros that keep the size lie as torch's padding='same' puts them: for a kernel
 * of two the missing value is behind the last one. */
TEST(Inference, AnEvenKernelReachesBehind)
{
  Network network{{1, 3},
                  {{LayerKind::Convolution, {1, 2}}, {LayerKind::Reshape, {3}}}};
  network.layers[0].weights = {{{1, 1, 2}, {1.0f, 10.0f}}, {{1}, {0.5f}}};
  EXPECT_EQ(networkScores(network, {{1, 2, 3}})[0], (Values{21.5f, 32.5f, 3.5f}));
}

TEST(Inference, DenseIsAsLoopsSay)
{
  for (const int size : {1, 3, 4, 30, 2501}) {
    const auto network = oneLayer({LayerKind::Dense, {6}}, {size});
    const auto& layer = network.layers[0];
    const auto values = randomValues(static_cast<std::size_t>(size), 8);
    Values expected;
    for (std::size_t row = 0; row < 6; ++row) {
      double sum = layer.weights[1].values[row];
      for (std::size_t k = 0; k < values.size(); ++k)
        sum += double(layer.weights[0].values[row * values.size() + k]) * values[k];
      expected.push_back(static_cast<float>(sum));
    }
    expectNear(networkScores(network, {values})[0], expected);
  }
}

TEST(Inference, ValuesOneByOne)
{
  const Values values = {4, -4, 0.25f, 0};
  EXPECT_EQ(networkScores(oneLayer({LayerKind::SquareRoot}, {4}), {values})[0],
            (Values{2, 0, 0.5f, 0}));
  EXPECT_EQ(networkScores(oneLayer({LayerKind::Relu}, {4}), {values})[0],
            (Values{4, 0, 0.25f, 0}));
  Layer dropout{LayerKind::Dropout};
  dropout.rate = 0.5f;
  EXPECT_EQ(networkScores(oneLayer(dropout, {4}), {values})[0], values);
  Network scale{{4}, {{LayerKind::Scale}}};
  scale.layers[0].weights = {{{4}, {2, 3, 4, 5}}, {{4}, {1, 0, 0, -1}}};
  EXPECT_EQ(networkScores(scale, {values})[0], (Values{9, -12, 1, -1}));
}

TEST(Inference, BatchNormIsPerChannel)
{
  Network network{{2, 2}, {{LayerKind::BatchNorm}, {LayerKind::Reshape, {4}}}};
  network.layers[0].weights = {
      {{2}, {1, 2}}, {{2}, {0.25f, 0}}, {{2}, {3, 1}}, {{2}, {0.5f, -1}}};
  const auto norm = [](double value, double mean, double variance) {
    return (value - mean) / std::sqrt(variance + 1e-5);
  };
  expectNear(networkScores(network, {{1, 2, 3, 2}})[0],
             {0.5f,
              static_cast<float>(3 * norm(2, 1, 0.25) + 0.5),
              static_cast<float>(norm(3, 2, 0) - 1),
              -1.0f});
  network.layers[0].weights[1].values[1] = -1.0f;
  EXPECT_THROW(networkScores(network, {{1, 2, 3, 2}}), BadArgumentException);
}

TEST(Inference, PoolingTakesTheLargestOfEachWindow)
{
  for (const auto& [input, window] : {ConvolutionCase{{2, 7}, {3}},
                                      ConvolutionCase{{3, 5, 4}, {2, 2}},
                                      ConvolutionCase{{2, 4, 5, 6}, {2, 1, 3}},
                                      ConvolutionCase{{2, 3, 4, 5, 4}, {3, 2, 2, 1}}}) {
    const auto values = randomValues(valueCount(input), 9);
    Layer layer{LayerKind::MaxPool, window};
    const auto output = outputShape(layer, input);
    Values expected(valueCount(output), -2.0f);
    for (const auto& from : indicesOf(input)) {
      Shape to = from;
      bool is_inside = true;
      for (std::size_t k = 1; k < to.size(); ++k) {
        to[k] /= window[k - 1];
        is_inside = is_inside && to[k] < output[k];
      }
      if (is_inside)
        expected[placeOf(to, output)] =
            std::max(expected[placeOf(to, output)], values[placeOf(from, input)]);
    }
    EXPECT_EQ(networkScores(oneLayer(layer, input), {values})[0], expected);
  }
  EXPECT_EQ(networkScores(oneLayer({LayerKind::MaxOverPositions}, {2, 3}),
                          {{1, 5, 3, -4, -6, -5}})[0],
            (Values{5, -4}));
}

/** A row of channels times the matrix, whose rows come one after the other. */
TEST(Inference, TransformMultipliesEachPosition)
{
  Layer transform{LayerKind::Transform};
  transform.inner = {{LayerKind::MaxOverPositions}, {LayerKind::Dense, {4}}};
  Network network{{2, 3}, {transform, {LayerKind::Reshape, {6}}}};
  // The matrix: (max 0, max 1; 0, 10 max 0), plus identity.
  network.layers[0].inner[1].weights = {{{4, 2}, {1, 0, 0, 1, 0, 0, 10, 0}},
                                        {{4}, {0, 0, 0, 0}}};
  // Maxima 3 and 7, so (4, 7; 0, 31).
  EXPECT_EQ(networkScores(network, {{1, 2, 3, 5, 6, 7}})[0],
            (Values{4, 8, 12, 7 + 155, 14 + 186, 21 + 217}));
}

TEST(Inference, NoObjectDependsOnItsBatch)
{
  for (auto network :
       {perceptron(5, {37, {19, 11}, 0.5f}), pointNet(4, 13, 0.1), eppfNetwork2D(3)}) {
    initializeWeights(network, 3);
    std::vector<Values> inputs;
    for (std::uint32_t k = 0; k < 7; ++k)
      inputs.push_back(randomValues(valueCount(network.input), k));
    const auto together = networkScores(network, inputs);
    ASSERT_EQ(together.size(), inputs.size());
    for (std::size_t k = 0; k < inputs.size(); ++k)
      EXPECT_EQ(networkScores(network, {inputs[k]})[0], together[k]);
    EXPECT_NE(together[0], together[1]);
  }
}

TEST(Inference, ResponsesAreThoseOfTheFirst)
{
  auto network = perceptron(2, {3, {4}, 0.0f});
  initializeWeights(network, 1);
  std::vector<Tensor> responses(9);
  const auto scores = networkScores(network, {{4, 9, 0}, {1, 1, 1}}, &responses);
  ASSERT_EQ(responses.size(), network.layers.size());
  EXPECT_EQ(responses[0].values, (Values{2, 3, 0}));
  EXPECT_EQ(responses[2].shape, (Shape{4}));
  EXPECT_EQ(responses.back().values, scores[0]);
}

TEST(Inference, RefusesWhatDoesNotFit)
{
  auto network = perceptron(2, {3, {}, 0.0f});
  EXPECT_THROW(networkScores(network, {}), BadArgumentException); // no weights
  initializeWeights(network, 1);
  EXPECT_TRUE(networkScores(network, {}).empty());
  EXPECT_THROW(networkScores(network, {{1, 2, 3}, {1, 2}}), BadArgumentException);
  network.layers.back().weights[0].values[0] = NAN;
  EXPECT_THROW(networkScores(network, {{1, 2, 3}}), BadArgumentException);
}

} // namespace
} // namespace pcl::indoor
