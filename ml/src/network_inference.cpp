/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "network_evaluation.h"

#include <pcl/exceptions.h>
#include <pcl/ml/network_inference.h>

namespace pcl {
namespace indoor {

std::vector<std::vector<float>>
networkScores(const Network& network,
              const std::vector<std::vector<float>>& inputs,
              std::vector<Tensor>* responses)
{
  const auto problem = whatIsWrong(network, true);
  if (!problem.empty())
    PCL_THROW_EXCEPTION(BadArgumentException, problem);
  for (const auto& input : inputs)
    if (input.size() != valueCount(network.input))
      PCL_THROW_EXCEPTION(BadArgumentException,
                          "An input of " << input.size()
                                         << " values does not fit a network of "
                                         << valueCount(network.input));
  if (responses != nullptr)
    responses->clear();
  ObjectValues objects{network.input, inputs};
  for (const auto& layer : network.layers) {
    applyLayer(layer, objects);
    if (responses != nullptr && !inputs.empty())
      responses->push_back({objects.shape, objects.arrays.front()});
  }
  return objects.arrays;
}

} // namespace indoor
} // namespace pcl
