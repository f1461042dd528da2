/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#ifdef _OPENMP
#include <omp.h>
#endif

namespace pcl {
namespace indoor {

/** \brief The number of threads to ask for.
 * \param[in] requested 0 or less = as many as the machine offers
 * \return at least 1; always 1 without OpenMP
 */
inline int
threadCount(int requested)
{
#ifdef _OPENMP
  return requested > 0 ? requested : omp_get_max_threads();
#else
  (void)requested;
  return 1;
#endif
}

} // namespace indoor
} // namespace pcl
