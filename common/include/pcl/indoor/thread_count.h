/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/exceptions.h>

#include <algorithm>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace pcl {
namespace indoor {

/** \brief The number of threads to use for a request, where 0 means automatic; at most
 * 1024: each needs memory for its stack.
 * \throws pcl::BadArgumentException if the request is negative
 */
inline int
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

} // namespace indoor
} // namespace pcl
