/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/options.h"
#include "objects/labelled_objects.h"
#include "objects/object_augmentation.h"

#include <pcl/ml/network_training.h>

#include <string>

namespace pcl::indoor::tool {

/** \brief How a perceptron on descriptors is trained: forty epochs are ten for each of
 * four draws. */
TrainingOptions
recommendedTraining();

/** \brief What pcl_eppf_train is asked for; the defaults are the training that is
 * recommended, see docs/guide/training.md. */
struct TrainingSettings {
  std::string folder;
  std::string model;

  std::string split = "none"; ///< none, folders, random:SHARE, or a list's path
  double validation = 0.0;    ///< share of the training part; 0: the last epoch counts

  std::string network = "perceptron";
  std::string hidden = "512"; ///< of the perceptron: values of its layers
  double dropout = 0.5;       ///< of the perceptron
  double input_dropout = 0.0; ///< of the perceptron
  double width = 1.0;         ///< of PointNet
  int ensemble = 1;           ///< networks

  std::string descriptor = "auto";
  std::string scale = "0"; ///< metres, or auto
  bool any_pose = false;   ///< else objects stand upright, metres
  DrawOptions draws;
  std::string augment = "scan"; ///< off, mild or scan

  TrainingOptions training = recommendedTraining();
  unsigned int threads = 0; ///< of reading and describing

  std::string log, curves, confusion;
  bool half_precision = false;
};

/** \brief Add the options to a parser; the settings must outlive its run(). */
void
addTo(OptionParser& parser, TrainingSettings& settings);

/** \brief Find out what is wrong with the settings before anything is read.
 * \throws ToolError naming the option
 */
void
requireUsable(const TrainingSettings& settings);

/** \brief What the model is fed with; scale "auto" needs the objects.
 * \param[in] used objects that count for the scale
 */
ClassifierInput
inputOf(const TrainingSettings& settings,
        const LabelledObjects& objects,
        const std::vector<std::size_t>& used);

/** \brief The network to train, without weights. */
Network
networkOf(const TrainingSettings& settings,
          const ClassifierInput& input,
          std::size_t class_count);

} // namespace pcl::indoor::tool
