/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/ml/network.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief What a model is fed with. */
enum class ClassifierInputKind {
  PairHarmonics, ///< the descriptor of pairs and harmonics, 1,200 bins
  EPPF,          ///< the thesis's descriptor, 1,200 bins
  EPPFShort,     ///< the thesis's short descriptor, 540 bins
  Points         ///< the points themselves, in the unit sphere around their mean
};

/** \brief How the input of a model is made of an object. */
struct ClassifierInput {
  ClassifierInputKind kind = ClassifierInputKind::PairHarmonics;
  double scale = 0.0; ///< metres that distances spread over; 0: each object's extent
  std::uint32_t pair_count = 20000; ///< pairs drawn, at least 1
  int draws = 1; ///< times an object is described, 1 ... most_draws; probabilities are
                 ///< averaged
  bool context =
      false; ///< whether contextValues() and uprightProfile() follow the bins
  int point_count = 1024; ///< of Points, 1 ... most_points
};

constexpr int most_draws = 1000;
constexpr int most_points = 1 << 20;

/** \brief A trained classifier: plain data, see model_file.h for its file. */
struct ClassifierModel {
  std::vector<std::string> classes; ///< names, in the order of the networks' scores
  ClassifierInput input;
  std::vector<Network> networks; ///< at least one; their probabilities are averaged
};

/** \brief Say what is wrong with a model: "" if nothing.
 * \param[in] wants_weights whether weights must be there, of their shapes and finite
 */
PCL_INDOOR_EXPORTS std::string
findProblem(const ClassifierModel& model, bool wants_weights = true);

} // namespace pcl::indoor
