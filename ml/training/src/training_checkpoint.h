/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/ml/network_training.h>

namespace pcl::indoor {

/** \brief All that a training needs to go on as if it had not stopped; its generators
 * start anew in each epoch. */
struct TrainingState {
  std::vector<EpochReport> epochs;
  int best_epoch = 0;
  std::int64_t step_count = 0; ///< of Adam
  Network network;
  Network best;                            ///< of the best epoch
  std::vector<std::vector<float>> moments; ///< of Adam
};

/** \brief What tells trainings apart, as hashes. */
struct TrainingIdentity {
  std::uint64_t network = 0; ///< layers and their first weights
  std::uint64_t options = 0; ///< those that the result depends on, but for patience
  std::uint64_t sets = 0;    ///< training and validation
};

TrainingIdentity
trainingIdentity(const Network& network,
                 const TrainingSet& training,
                 const TrainingSet& validation,
                 const TrainingOptions& options);

/** \brief Check that a checkpoint could be written.
 * \throws pcl::IOException if not
 */
void
requireWritable(const std::string& file);

/** \brief Write a state beside the file, then rename it.
 * \throws pcl::IOException if this fails
 */
void
writeCheckpoint(const std::string& file,
                const TrainingIdentity& identity,
                const TrainingState& state);

/** \brief Read a state if there is a file.
 * \param[in,out] state in: networks and moments of the training's sizes
 * \return whether there is one
 * \throws pcl::IOException if it is damaged or of another training
 */
bool
readCheckpoint(const std::string& file,
               const TrainingIdentity& identity,
               TrainingState& state);

} // namespace pcl::indoor
