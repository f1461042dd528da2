/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

namespace pcl::indoor::tool {

/** \brief How many threads readers of files use; 0 (the default): as many as the
 * machine offers. What is read does not depend on it. */
int
readerThreads();

/** \brief Set it for the whole program, as its option -threads says. */
void
setReaderThreads(int threads);

} // namespace pcl::indoor::tool
