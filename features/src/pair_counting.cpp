/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/pair_counting.h>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace pcl {
namespace indoor {

int
pairThreadCount(unsigned int wanted)
{
#ifdef _OPENMP
  return wanted == 0 ? omp_get_max_threads()
                     : static_cast<int>(std::min(wanted, 1024u));
#else
  static_cast<void>(wanted);
  return 1;
#endif
}

} // namespace indoor
} // namespace pcl
