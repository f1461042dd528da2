/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <functional>
#include <string>

namespace pcl::indoor::tool {

/** \brief Run a class of PCL's kind: why it gives nothing, it only prints.
 *
 * Several threads may do so at a time, each has its own errors.
 * \param[in] run nothing else is to be printed on stderr meanwhile: it is lost
 * \return the first error that would have been printed, without the names of class and
 * function; empty if there was none
 */
PCL_INDOOR_EXPORTS std::string
problemOf(const std::function<void()>& run);

} // namespace pcl::indoor::tool
