/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/parallel_for.h>

#include <cstddef>
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
  parallelFor(static_cast<std::ptrdiff_t>(count),
              static_cast<int>(number_of_threads),
              1,
              [&visit](std::ptrdiff_t k) { visit(static_cast<std::size_t>(k)); });
}

} // namespace indoor
} // namespace pcl
