/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/threads.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>

namespace pcl::indoor {

/** \brief Call with each number below a count, from several threads; what is thrown
 * arrives at the caller.
 *
 * An exception that leaves an OpenMP region ends the program, and each allocation may
 * throw one: such loops are written with this function.
 * \param[in] threads 0 or less: as many as the machine offers
 * \param[in] chunk so many numbers a thread takes at a time
 * \param[in] make_state called once in each thread; what it returns belongs to the
 * thread
 * \param[in] visit called with the thread's state and a number
 * \param[in] finish called with the state of each thread at its end, one after the
 * other in no certain order
 * \throws the first exception that was thrown; what was not yet begun is left out
 */
template <typename MakeState, typename Visit, typename Finish>
void
parallelFor(std::ptrdiff_t count,
            int threads,
            std::ptrdiff_t chunk,
            const MakeState& make_state,
            const Visit& visit,
            const Finish& finish)
{
  std::atomic<std::ptrdiff_t> next(0);
  std::exception_ptr problem;
  std::mutex mutex; // of the problem, and of what finish() writes
  runInThreads(threadCount(std::max(threads, 0)), [&] {
    try {
      auto state = make_state();
      for (auto i = next.fetch_add(chunk); i < count; i = next.fetch_add(chunk))
        for (const auto end = std::min(count, i + chunk); i < end; ++i)
          visit(state, i);
      const std::lock_guard<std::mutex> lock(mutex);
      finish(state);
    } catch (...) {
      next = count;
      const std::lock_guard<std::mutex> lock(mutex);
      if (!problem)
        problem = std::current_exception();
    }
  });
  if (problem)
    std::rethrow_exception(problem);
}

/** \brief The same without an end of each thread. */
template <typename MakeState, typename Visit>
void
parallelFor(std::ptrdiff_t count,
            int threads,
            std::ptrdiff_t chunk,
            const MakeState& make_state,
            const Visit& visit)
{
  parallelFor(count, threads, chunk, make_state, visit, [](const auto&) {});
}

/** \brief The same without state; \a visit is called with a number. */
template <typename Visit>
void
parallelFor(std::ptrdiff_t count, int threads, std::ptrdiff_t chunk, const Visit& visit)
{
  parallelFor(
      count,
      threads,
      chunk,
      [] { return 0; },
      [&visit](int, std::ptrdiff_t i) { visit(i); });
}

/** \brief The share of a thread if each has one. */
inline std::ptrdiff_t
evenChunk(std::ptrdiff_t count, int threads)
{
  return count / std::max(1, threads) + 1;
}

} // namespace pcl::indoor
