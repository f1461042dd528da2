/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

namespace pcl::indoor::tool {

/** \brief What is left of the machine's memory: of MemAvailable in /proc/meminfo and
 * the limit of the control group, the less; bytes, 0 if unknown. */
PCL_INDOOR_EXPORTS double
availableMemory();

} // namespace pcl::indoor::tool
