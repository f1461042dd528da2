/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <exception>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace pcl::indoor {

/** \brief Call a function with 0 ... count - 1, by several threads.
 * \param[in] threads 0 = automatic
 * \throws what the function throws, once all calls are done */
template <typename Function>
void
loopInParallel(std::size_t count, int threads, const Function& function)
{
  std::exception_ptr failure; // none may leave a parallel loop
  const auto end = static_cast<std::ptrdiff_t>(count);
#ifdef _OPENMP
  const int used = threads > 0 ? threads : omp_get_max_threads();
#pragma omp parallel for schedule(dynamic) num_threads(used)
#endif
  for (std::ptrdiff_t i = 0; i < end; ++i) {
    try {
      function(static_cast<std::size_t>(i));
    } catch (...) {
#pragma omp critical(pcl_indoor_loop)
      failure = std::current_exception();
    }
  }
  if (failure)
    std::rethrow_exception(failure);
}

} // namespace pcl::indoor
