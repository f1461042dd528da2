/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>

#include <algorithm>
#include <cstddef>
#include <functional>

namespace pcl::indoor {

/** \brief Get the number of threads to use for a request, where 0 means automatic; at
 * most 1024: each needs memory for its stack. Always 1 if the library has no OpenMP.
 * \throws pcl::BadArgumentException if the request is negative
 */
PCL_INDOOR_EXPORTS int
threadCount(int requested);

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
 * \return at least 1
 */
inline int
usefulThreads(int requested, std::size_t work, std::size_t share)
{
  return std::min(threadCount(std::max(requested, 0)),
                  static_cast<int>(std::min<std::size_t>(work / share + 1, 1024)));
}

/** \brief Call a function once in each of so many threads at the same time; in one if
 * the library has no OpenMP. How the caller was compiled does not matter.
 * \param[in] work must not throw
 */
PCL_INDOOR_EXPORTS void
runInThreads(int threads, const std::function<void()>& work);

} // namespace pcl::indoor
