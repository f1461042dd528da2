/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace pcl {
namespace indoor {

constexpr std::size_t pair_block_size = 512; ///< pairs that are worked on together

/** \brief Number of threads to use for a number asked for, 0 meaning all. */
int
pairThreadCount(unsigned int wanted);

/** \brief Counts of all pairs per bin, block after block on several threads.
 *
 * Sums of integers are the same in any order, so that no result depends on the threads.
 * \tparam Count an integer type
 * \param[in] count_block called with the first pair of a block, one past its last, and
 * the counts of the calling thread to add to
 */
template <typename Count = std::uint32_t, typename CountBlock>
std::vector<Count>
countPairs(std::size_t pair_count,
           std::size_t bin_count,
           unsigned int number_of_threads,
           const CountBlock& count_block)
{
  std::vector<Count> counts(bin_count);
  const auto block_count =
      static_cast<std::int64_t>((pair_count + pair_block_size - 1) / pair_block_size);
  const int threads = static_cast<int>(
      std::min<std::int64_t>(pairThreadCount(number_of_threads), block_count));
  const auto count = [&](std::int64_t block, std::vector<Count>& own) {
    const std::size_t first = static_cast<std::size_t>(block) * pair_block_size;
    count_block(first, std::min(first + pair_block_size, pair_count), own);
  };
  if (threads == 1) {
    for (std::int64_t block = 0; block < block_count; ++block)
      count(block, counts);
    return counts;
  }
#pragma omp parallel num_threads(threads)
  {
    std::vector<Count> own(bin_count);
#pragma omp for schedule(dynamic, 1) nowait
    for (std::int64_t block = 0; block < block_count; ++block)
      count(block, own);
#pragma omp critical(pcl_indoor_pair_counts)
    std::transform(
        own.begin(), own.end(), counts.begin(), counts.begin(), std::plus<>());
  }
  return counts;
}

} // namespace indoor
} // namespace pcl
