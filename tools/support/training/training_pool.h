/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/progress.h"
#include "objects/labelled_objects.h"
#include "objects/object_augmentation.h"

#include <pcl/ml/network_training.h>

namespace pcl::indoor::tool {

/** \brief Draws of objects as a set to train with.
 * \param[in] used indices of the objects, which also decide the draws' seeds
 * \param[in] number_of_threads 0: as many as the machine has; any gives the same
 * \throws ToolError naming the first object that cannot be described and their number
 */
TrainingSet
trainingPool(const LabelledObjects& objects,
             const std::vector<std::size_t>& used,
             const DrawOptions& options,
             unsigned int number_of_threads,
             Progress& progress);

} // namespace pcl::indoor::tool
