/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <algorithm>
#include <cstddef>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace pcl {
namespace indoor {

// static: what it returns depends on how the including file is compiled
/** \brief The number of threads that a piece of work is worth.
 * \param[in] requested 0 or less = as many as the machine offers
 * \param[in] work number of items
 * \param[in] share items that are worth a thread of their own (at least 1)
 * \return at least 1; always 1 without OpenMP
 */
static inline int
usefulThreads(int requested, std::size_t work, std::size_t share)
{
#ifdef _OPENMP
  const int allowed = requested > 0 ? requested : omp_get_max_threads();
#else
  const int allowed = 1;
  (void)requested;
#endif
  return std::min(allowed,
                  static_cast<int>(std::min<std::size_t>(work / share + 1, 1024)));
}

} // namespace indoor
} // namespace pcl
