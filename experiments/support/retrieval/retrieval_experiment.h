/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/progress.h"
#include "objects/labelled_objects.h"
#include "objects/object_disturbance.h"
#include "retrieval/retrieval_descriptors.h"

#include <pcl/ml/classification_metrics.h>
#include <pcl/ml/histogram_distance.h>

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief What an experiment does besides describing. */
struct ExperimentSettings {
  int repeat_count = 10;
  int neighbor_count = 20; ///< of normals and curvatures that have to be estimated
  Disturbance disturbance;
  bool clean_gallery = false; ///< compare disturbed objects with clean ones
  std::vector<HistogramDistance> distances;
  std::uint32_t seed = 1; ///< of pairs, noise and views; repeats count up from it
  unsigned int number_of_threads =
      1; ///< of the distances; describing is timed with one
};

/** \brief Scores of one descriptor with one distance. */
struct RetrievalResult {
  std::string descriptor;
  HistogramDistance distance = HistogramDistance::L1;
  std::size_t bin_count = 0;
  std::size_t repeat_count = 0;
  Spread total_accuracy;
  Spread mean_accuracy;
  Spread mean_recall;
  Spread f1;
  Spread milliseconds;           ///< per object, one thread
  double distance_seconds = 0.0; ///< all distances of one repeat
  ConfusionMatrix confusion;     ///< of the first repeat
};

/** \brief Leave-one-out retrieval of every descriptor, Sec. 5.3.2.
 *
 * All descriptors of a repeat see the same disturbed objects.
 * \return per descriptor and distance, in the order given
 */
std::vector<RetrievalResult>
runRetrieval(const LabelledObjects& objects,
             const std::vector<RetrievalDescriptor>& descriptors,
             const ExperimentSettings& settings,
             Progress& progress);

/** \brief For example "kl". */
std::string
distanceName(HistogramDistance distance);

} // namespace pcl::indoor::tool
