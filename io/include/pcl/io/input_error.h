/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <stdexcept>

namespace pcl::indoor {

/** \brief What is given cannot be used, or a result cannot be written; its text, one
 * line for a user, names file or option, problem and value. */
class PCL_INDOOR_EXPORTS InputError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

} // namespace pcl::indoor
