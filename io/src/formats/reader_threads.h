/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

namespace pcl::indoor::tool {

/** \brief How many threads readers of files use; 0 (the default): as many as the
 * machine offers. What is read does not depend on it. */
int
readerThreads();

/** \brief Set it for the whole program, as its option -threads says. */
PCL_INDOOR_EXPORTS void
setReaderThreads(int threads);

} // namespace pcl::indoor::tool
