/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/reader_threads.h"

#include <atomic>

namespace pcl::indoor::tool {
namespace {

std::atomic<int> thread_number(0);

} // namespace

int
readerThreads()
{
  return thread_number;
}

void
setReaderThreads(int threads)
{
  thread_number = threads;
}

} // namespace pcl::indoor::tool
