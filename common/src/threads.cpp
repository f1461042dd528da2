/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/indoor/threads.h>

#include <pcl/exceptions.h>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace pcl::indoor {

int
threadCount(int requested)
{
  if (requested < 0)
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "The number of threads must not be negative, not " << requested
                                                                           << ".");
#ifdef _OPENMP
  return requested > 0 ? std::min(requested, 1024) : omp_get_max_threads();
#else
  return 1;
#endif
}

void
runInThreads([[maybe_unused]] int threads, const std::function<void()>& work)
{
#pragma omp parallel num_threads(threads) if (threads > 1)
  work();
}

} // namespace pcl::indoor
