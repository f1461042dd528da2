/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/ml/network_training.h>

#include <ATen/ATen.h>

namespace pcl::indoor {

/** \brief A TrainingSet as two arrays: a row per draw, object after object. */
struct TrainingData {
  at::Tensor inputs;                   ///< (draws, values)
  at::Tensor labels;                   ///< (draws)
  std::vector<std::int64_t> first_row; ///< of each object, and the number of draws
};

TrainingData
trainingData(const TrainingSet& set, const at::Device& device);

/** \brief The rows of an epoch in its order: a draw of each object. */
std::vector<std::int64_t>
drawnRows(const TrainingData& data, std::uint32_t seed, int epoch);

/** \brief Where batches begin, and the number of objects. Nothing is left out; no batch
 * has a single object, which BatchNorm could not take, unless they all do. */
std::vector<std::int64_t>
batchBounds(std::int64_t object_count, std::int64_t batch_size);

} // namespace pcl::indoor
