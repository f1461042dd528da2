/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "training_resources.h"

#include <ATen/Parallel.h>

#include <limits>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace pcl::indoor {

namespace {

void
setMemory([[maybe_unused]] int most_maps, [[maybe_unused]] int trim_threshold)
{
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, most_maps);
  mallopt(M_TRIM_THRESHOLD, trim_threshold);
#endif
}

} // namespace

TrainingResources::TrainingResources(int threads)
: threads_before_(at::get_num_threads())
{
  at::set_num_threads(threads);
  setMemory(0, std::numeric_limits<int>::max());
}

TrainingResources::~TrainingResources()
{
  setMemory(65536, 128 * 1024); // glibc's defaults
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  at::set_num_threads(threads_before_);
}

} // namespace pcl::indoor
