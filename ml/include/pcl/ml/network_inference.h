/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/ml/network.h>

#include <vector>

namespace pcl::indoor {

/** \brief The network's scores (before the softmax) of a batch of inputs.
 *
 * Sums have a fixed order: the scores of an object are the same bits alone and in any
 * batch. One thread; a larger batch reads the weights of dense layers less often.
 * \param[in] inputs one per object, of the network's input
 * \param[out] responses if not null: the values after each layer for the first object
 * \throws pcl::BadArgumentException if network or inputs do not fit
 */
PCL_INDOOR_EXPORTS std::vector<std::vector<float>>
networkScores(const Network& network,
              const std::vector<std::vector<float>>& inputs,
              std::vector<Tensor>* responses = nullptr);

} // namespace pcl::indoor
