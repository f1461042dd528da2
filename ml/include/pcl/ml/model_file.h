/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/ml/classifier_model.h>

#include <string>

namespace pcl::indoor {

/** \brief A model as the bytes of its file.
 *
 * A line that names format and version, a line of JSON (classes, input, layers, how
 * weights are stored), the weights, and checksums of both: docs/method/classes.md.
 * \param[in] half_precision store weights of dense and convolution layers in 16 bits
 * instead of 32
 * \throws pcl::BadArgumentException if the model is wrong, a name of a class is not
 * UTF-8, or a weight is too large for 16 bits
 */
PCL_INDOOR_EXPORTS std::string
modelBytes(const ClassifierModel& model, bool half_precision = false);

/** \brief The model of a file's bytes.
 * \throws pcl::IOException that says in one line what is wrong with them: not a model,
 * of a newer version, damaged, cut off, or not fitting itself
 */
PCL_INDOOR_EXPORTS ClassifierModel
modelFromBytes(const std::string& bytes);

/** \brief The model of a file.
 * \throws pcl::IOException as modelFromBytes(), with the path, and if there is no such
 * file
 */
PCL_INDOOR_EXPORTS ClassifierModel
loadModel(const std::string& path);

} // namespace pcl::indoor
