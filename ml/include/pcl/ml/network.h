/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief Extents of an array, the last one fastest. */
using Shape = std::vector<int>;

/** \brief Number of values of an array; 1 for no extents. */
PCL_INDOOR_EXPORTS std::size_t
valueCount(const Shape& shape);

/** \brief Added to the variances of LayerKind::BatchNorm. */
constexpr double batch_norm_epsilon = 1e-5;

/** \brief What a layer does to the values of one object.
 *
 * Values come as an array of shape (channels, positions ...), with up to four extents
 * of positions.
 */
enum class LayerKind {
  Scale, ///< value * weights[0] + weights[1], each of the input's shape; not trained
  SquareRoot,  ///< root of each value; negative values count as 0
  Reshape,     ///< the same values in another shape: extents
  Dense,       ///< all values to extents[0] ones: weights (out, in) and biases (out)
  Convolution, ///< extents: channels out, then the kernel's extent per position extent;
               ///< stride 1, zeros around ((n - 1) / 2 before, rounded down, the rest
               ///< of n - 1 after), so that the positions stay: weights (out, in,
               ///< kernel ...), biases (out)
  BatchNorm,   ///< per channel: weights mean, variance, gain, offset (channels) each;
               ///< (value - mean) / sqrt(variance + batch_norm_epsilon) * gain + offset
  Relu,        ///< max(value, 0)
  MaxPool, ///< largest value per window of extents, one per position extent; windows
           ///< lie side by side, what does not fill one is left out
  MaxOverPositions, ///< the largest value of each channel: shape (channels)
  Transform, ///< each position's channels, as a row, times the square matrix that inner
             ///< makes of the input, plus identity (PointNet's transform nets)
  Dropout    ///< in training, rate of the values become 0; else nothing
};

/** \brief Weights or biases of a layer. */
struct Tensor {
  Shape shape;
  std::vector<float> values; ///< valueCount(shape) of them
};

/** \brief One layer of a network; see LayerKind for what it needs. */
struct Layer {
  LayerKind kind = LayerKind::Relu;
  Shape extents{};               ///< of Reshape, Dense, Convolution, MaxPool
  float rate = 0.0f;             ///< of Dropout, 0 ... 1
  std::vector<Layer> inner{};    ///< of Transform
  std::vector<Tensor> weights{}; ///< empty until initialized or trained
};

/** \brief A feed-forward network: plain data, of which the last layer gives one score
 * per class. */
struct Network {
  Shape input; ///< of one object, for example (1, 20, 4, 5, 3) or (3, 1024)
  std::vector<Layer> layers;
};

/** \brief The shape of what a layer makes of an input.
 * \throws pcl::BadArgumentException if the layer does not fit the input
 */
PCL_INDOOR_EXPORTS Shape
outputShape(const Layer& layer, const Shape& input);

/** \brief The shape of what layers make of an input, one after the other; the input's
 * for no layers.
 * \throws pcl::BadArgumentException if one does not fit its input
 */
PCL_INDOOR_EXPORTS Shape
outputShape(const std::vector<Layer>& layers, const Shape& input);

/** \brief The shapes of a layer's weights, in the order of LayerKind; none for most.
 * \throws pcl::BadArgumentException as outputShape()
 */
PCL_INDOOR_EXPORTS std::vector<Shape>
weightShapes(const Layer& layer, const Shape& input);

/** \brief Say what is wrong with a network: "" if nothing. All layers must fit, and if
 * wants_weights, all weights be there, of their shapes and finite. */
PCL_INDOOR_EXPORTS std::string
findProblem(const Network& network, bool wants_weights);

/** \brief Fill in weights where there are none.
 *
 * Dense and Convolution: normal, cut off at two deviations, of variance 2 / inputs of a
 * value; biases 0.1, as the thesis's authors have them. BatchNorm and Scale: no change
 * of values. The last dense layer of a Transform starts at 0, so that the matrix starts
 * as identity. The same seed gives the same bits.
 * \throws pcl::BadArgumentException if the network is wrong
 */
PCL_INDOOR_EXPORTS void
initializeWeights(Network& network, std::uint32_t seed);

/** \brief Number of trained values of a network: all weights but those of Scale. */
PCL_INDOOR_EXPORTS std::size_t
trainedValueCount(const Network& network);

} // namespace pcl::indoor
