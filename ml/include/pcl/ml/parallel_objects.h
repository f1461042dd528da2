/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <pcl/indoor/threads.h>

#include <cstdint>
#include <exception>

namespace pcl {
namespace indoor {

/** \brief Call with each number below a count, from several threads.
 * \param[in] number_of_threads 0: as many as the machine has
 * \throws one of the exceptions that calls have thrown, after all have ended
 */
template <typename Visit>
void
forEachObject(std::size_t count, unsigned int number_of_threads, const Visit& visit)
{
  std::exception_ptr problem;
#pragma omp parallel for schedule(dynamic) num_threads(threadCount(number_of_threads))
  for (std::int64_t k = 0; k < static_cast<std::int64_t>(count); ++k)
    try {
      visit(static_cast<std::size_t>(k));
    } catch (...) {
#pragma omp critical(pcl_indoor_for_each_object)
      problem = std::current_exception();
    }
  if (problem)
    std::rethrow_exception(problem);
}

} // namespace indoor
} // namespace pcl
