/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/network_inference.h>

#include "network_evaluation.h"

#include <pcl/exceptions.h>
#include <pcl/indoor/require_valid.h>

#include <algorithm>
#include <cstddef>

namespace pcl::indoor {

std::vector<std::vector<float>>
networkScores(const Network& network,
              const std::vector<std::vector<float>>& inputs,
              std::vector<Tensor>* responses)
{
  requireValid(network, true);
  for (const auto& input : inputs)
    if (input.size() != valueCount(network.input))
      PCL_THROW_EXCEPTION(BadArgumentException,
                          "An input of " << input.size()
                                         << " values does not fit a network of "
                                         << valueCount(network.input));
  if (responses != nullptr)
    responses->clear();
  std::vector<std::vector<float>> scores;
  for (std::size_t first = 0; first < inputs.size(); first += inputs_at_once) {
    const auto begin = inputs.begin() + static_cast<std::ptrdiff_t>(first);
    const auto count = std::min(inputs.size() - first, inputs_at_once);
    ObjectValues objects{network.input,
                         {begin, begin + static_cast<std::ptrdiff_t>(count)}};
    for (const auto& layer : network.layers) {
      applyLayer(layer, objects);
      if (responses != nullptr && first == 0)
        responses->push_back({objects.shape, objects.arrays.front()});
    }
    for (auto& values : objects.arrays)
      scores.push_back(std::move(values));
  }
  return scores;
}

} // namespace pcl::indoor
