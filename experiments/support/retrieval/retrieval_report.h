/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/confusion_picture.h"
#include "retrieval/retrieval_experiment.h"

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The results at one level of noise. */
struct RetrievalLevel {
  double noise_percent = 0.0;
  std::vector<RetrievalResult> results;
};

/** \brief A line per descriptor and distance, for a terminal. */
std::string
resultTable(const std::vector<RetrievalResult>& results);

/** \brief Everything that was measured, as JSON text. */
std::string
resultJson(const std::vector<RetrievalLevel>& levels,
           const LabelledObjects& objects,
           const ExperimentSettings& settings);

/** \brief Total accuracy over the noise, a line per descriptor, of the first distance.
 */
SvgDrawing
noisePicture(const std::vector<RetrievalLevel>& levels);

/** \brief F1 of each result as a bar with its deviation, as Fig. 5.11 to 5.13. */
SvgDrawing
barPicture(const std::vector<RetrievalResult>& results);

} // namespace pcl::indoor::tool
