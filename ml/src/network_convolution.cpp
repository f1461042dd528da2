/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "network_evaluation.h"
#include "row_products.h"

#include <algorithm>
#include <array>

namespace pcl::indoor {

namespace {

using Extents = std::array<std::size_t, 4>;

/** \brief The extents behind the first, with ones before them to make four. */
Extents
positionExtents(const Shape& shape)
{
  Extents extents{1, 1, 1, 1};
  std::transform(shape.rbegin(), shape.rend() - 1, extents.rbegin(), [](int extent) {
    return static_cast<std::size_t>(extent);
  });
  return extents;
}

std::size_t
product(const Extents& extents)
{
  return extents[0] * extents[1] * extents[2] * extents[3];
}

std::size_t
offset(const Extents& position, const Extents& extents)
{
  return ((position[0] * extents[1] + position[1]) * extents[2] + position[2]) *
             extents[3] +
         position[3];
}

/** \brief Call with each position of an array, the last extent fastest. */
template <typename Visit>
void
forEachPosition(const Extents& extents, const Visit& visit)
{
  Extents p{};
  for (p[0] = 0; p[0] < extents[0]; ++p[0])
    for (p[1] = 0; p[1] < extents[1]; ++p[1])
      for (p[2] = 0; p[2] < extents[2]; ++p[2])
        for (p[3] = 0; p[3] < extents[3]; ++p[3])
          visit(p);
}

/** \brief An input with the zeros around it that keep the number of positions. */
struct PaddedInput {
  std::vector<float> values;
  std::vector<std::size_t> positions; ///< offset of each position's first kernel value
  std::vector<std::size_t> kernel; ///< from there, offset of each value of the kernel
};

PaddedInput
paddedInput(std::size_t channels,
            const Extents& extents,
            const Extents& kernel,
            const std::vector<float>& values)
{
  Extents padded;
  Extents before;
  for (std::size_t k = 0; k < 4; ++k) {
    padded[k] = extents[k] + kernel[k] - 1;
    before[k] = (kernel[k] - 1) / 2;
  }
  const std::size_t first = offset(before, padded);
  const std::size_t channel_size = product(padded);
  PaddedInput input;
  input.values.resize(channels * channel_size);
  input.positions.reserve(product(extents));
  forEachPosition(extents, [&](const Extents& position) {
    input.positions.push_back(offset(position, padded));
  });
  for (std::size_t channel = 0, k = 0; channel < channels; ++channel) {
    float* const place = input.values.data() + channel * channel_size + first;
    for (const std::size_t position : input.positions)
      place[position] = values[k++];
    forEachPosition(kernel, [&](const Extents& position) {
      input.kernel.push_back(channel * channel_size + offset(position, padded));
    });
  }
  return input;
}

} // namespace

std::vector<float>
convolution(const Layer& layer, const Shape& shape, const std::vector<float>& values)
{
  const auto extents = positionExtents(shape);
  const auto input = paddedInput(static_cast<std::size_t>(shape.front()),
                                 extents,
                                 positionExtents(layer.extents),
                                 values);
  const auto channels = static_cast<std::size_t>(layer.extents.front());
  const std::size_t count = input.positions.size();
  const std::size_t size = input.kernel.size();
  std::vector<float> output(channels * count);
  for (std::size_t channel = 0; channel < channels; ++channel)
    std::fill_n(output.begin() + static_cast<std::ptrdiff_t>(channel * count),
                count,
                layer.weights[1].values[channel]);
  // What the kernel sees at some positions is laid out in rows that stay in the cache.
  const std::size_t row_count = std::clamp<std::size_t>(65536 / size, 3, count + 2);
  std::vector<float> rows(row_count * size);
  for (std::size_t first = 0; first < count; first += row_count) {
    const std::size_t last = std::min(first + row_count, count);
    float* value = rows.data();
    for (std::size_t position = first; position < last; ++position) {
      const float* const place = input.values.data() + input.positions[position];
      for (const std::size_t from : input.kernel)
        *value++ = place[from];
    }
    addRowProducts({layer.weights[0].values.data(), channels},
                   {rows.data(), last - first},
                   size,
                   output.data() + first,
                   count,
                   1);
  }
  return output;
}

std::vector<float>
maxPool(const Layer& layer, const Shape& shape, const std::vector<float>& values)
{
  const auto extents = positionExtents(shape);
  Shape window_shape = layer.extents;
  window_shape.insert(window_shape.begin(), 1);
  const auto window = positionExtents(window_shape);
  Extents pooled;
  for (std::size_t k = 0; k < 4; ++k)
    pooled[k] = extents[k] / window[k];
  std::vector<float> output;
  output.reserve(static_cast<std::size_t>(shape.front()) * product(pooled));
  const std::size_t channel_size = product(extents);
  for (std::size_t first = 0; first < values.size(); first += channel_size)
    forEachPosition(pooled, [&](const Extents& position) {
      Extents corner;
      for (std::size_t k = 0; k < 4; ++k)
        corner[k] = position[k] * window[k];
      const float* const place = values.data() + first + offset(corner, extents);
      float largest = *place;
      forEachPosition(window, [&](const Extents& step) {
        largest = std::max(largest, place[offset(step, extents)]);
      });
      output.push_back(largest);
    });
  return output;
}

} // namespace pcl::indoor
