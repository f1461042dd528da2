/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/ml/network.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief Objects to train with: several draws of each, as differing as the objects
 * that the network will meet (pairs, noise, hidden parts). */
struct TrainingSet {
  std::vector<std::vector<std::vector<float>>> inputs; ///< [object][draw][value]
  std::vector<int> labels;                             ///< class of each object, from 0
};

/** \brief Parameters of trainNetwork(). */
struct TrainingOptions {
  int epoch_count = 100;       ///< most, at least 1; each meets each object once
  int batch_size = 64;         ///< objects per step, at least 1
  double learning_rate = 5e-4; ///< of Adam at the start; falls to 0 along a half cosine
  double weight_decay = 0.0;   ///< of AdamW, at least 0
  double label_smoothing = 0.0; ///< 0 ... 1
  double class_balance = 0.0;   ///< an object weighs as the number of objects of its
                                ///< class to the power of minus this, 0 ... 1
  int patience = 0; ///< stop after so many epochs without a better validation; 0: never
  std::uint32_t seed = 1; ///< of order, draws and dropout; same seed, same bits
  int threads = 1;        ///< of libtorch; another number may give other bits
  std::string checkpoint; ///< file to keep the state in; goes on from it if it is there
  int checkpoint_epochs = 10; ///< between two states, at least 1
};

/** \brief What an epoch gave. */
struct EpochReport {
  int epoch = 0;                    ///< 1 ...
  double training_loss = 0.0;       ///< what is minimized, while it is trained with
  double training_accuracy = 0.0;   ///< 0 ... 1
  double validation_loss = 0.0;     ///< plain cross-entropy of all draws, 0 without any
  double validation_accuracy = 0.0; ///< 0 ... 1
};

/** \brief What training gave. */
struct TrainingResult {
  Network network;                 ///< of the best epoch on validation, else the last
  std::vector<EpochReport> epochs; ///< all, also those before a resume
  int best_epoch = 0;
};

/** \brief Train a network with libtorch: AdamW on the cross-entropy.
 *
 * On a CUDA device where libtorch has one (Debian's has none), else on the CPU. Best is
 * the epoch of the highest validation accuracy and, of equal ones, of the lowest loss.
 * BatchNorm's running values follow with a momentum of 0.1. While it trains, glibc
 * keeps what the process frees.
 * \param[in] network initialized or trained before; its Scale layers stay as they are
 * \param[in] validation may be empty; never trained with
 * \param[in] report called after each epoch; false stops
 * \throws pcl::BadArgumentException if options, sets or network do not fit;
 * pcl::IOException if a checkpoint cannot be read or written, or is another training's;
 * pcl::ComputeFailedException if the loss is no longer finite
 */
PCL_INDOOR_EXPORTS TrainingResult
trainNetwork(const Network& network,
             const TrainingSet& training,
             const TrainingSet& validation,
             const TrainingOptions& options,
             const std::function<bool(const EpochReport&)>& report = {});

/** \brief Set a first Scale layer, if there is one, from a set.
 *
 * Each value that reaches it gets mean 0. Before a convolution all are divided by one
 * number, the mean of their deviations, so that the values that a kernel sees together
 * keep their proportions. Before other layers each is divided by its own deviation plus
 * that mean: what hardly ever differs, a new object might blow up else.
 * \throws pcl::BadArgumentException if the set is empty or does not fit
 */
PCL_INDOOR_EXPORTS void
fitScale(Network& network, const TrainingSet& set);

} // namespace pcl::indoor
