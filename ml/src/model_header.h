/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/ml/classifier_model.h>

#include <cstddef>
#include <string>

namespace pcl::indoor {

/** \brief What the second line of a model file says. */
struct ModelHeader {
  ClassifierModel model; ///< without weights
  bool half_precision = false;
  std::size_t weight_bytes = 0; ///< that follow the header
};

/** \brief The header as one line of JSON, without its end.
 * \throws pcl::BadArgumentException if a name is not UTF-8
 */
std::string
headerText(const ModelHeader& header);

/** \brief Read a header; whether its parts fit each other is not checked.
 * \throws pcl::IOException if it is not JSON, lacks a part, or one is of another type
 */
ModelHeader
readHeader(const std::string& text);

} // namespace pcl::indoor
