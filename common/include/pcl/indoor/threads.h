/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/exceptions.h>

#include <algorithm>
#include <cstddef>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace pcl {
namespace indoor {

/** \brief Get the number of threads to use for a request, where 0 means automatic; at
 * most 1024: each needs memory for its stack.
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

/** \brief The same for a request that cannot be negative. */
inline int
threadCount(unsigned requested)
{
  return threadCount(static_cast<int>(std::min(requested, 1024u)));
}

/** \brief Get the number of threads that a piece of work is worth.
 * \param[in] requested 0 or less = as many as the machine offers
 * \param[in] work number of items
 * \param[in] share items that are worth a thread of their own (at least 1)
 * \return at least 1; always 1 without OpenMP
 */
inline int
usefulThreads(int requested, std::size_t work, std::size_t share)
{
  return std::min(threadCount(std::max(requested, 0)),
                  static_cast<int>(std::min<std::size_t>(work / share + 1, 1024)));
}

} // namespace indoor
} // namespace pcl
