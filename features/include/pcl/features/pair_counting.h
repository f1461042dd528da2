/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>
#include <utility>
#include <vector>

namespace pcl::indoor {

constexpr std::size_t pair_block_size = 512; ///< pairs that are worked on together

/** \brief Counts per bin, block after block on several threads.
 *
 * Sums of integers are the same in any order, so that no result depends on the threads.
 * \param[in] count_block called with the number of a block and the counts of the
 * calling thread to add to
 */
template <typename CountBlock>
std::vector<std::uint64_t>
countBlocks(std::size_t block_count,
            std::size_t bin_count,
            unsigned int number_of_threads,
            const CountBlock& count_block)
{
  std::vector<std::uint64_t> counts(bin_count);
  const auto last = static_cast<std::int64_t>(block_count);
  const int threads =
      static_cast<int>(std::min<std::int64_t>(threadCount(number_of_threads), last));
  if (threads <= 1) {
    for (std::int64_t block = 0; block < last; ++block)
      count_block(static_cast<std::size_t>(block), counts);
    return counts;
  }
  using Counts = std::vector<std::uint64_t>;
  parallelFor(
      last,
      threads,
      1,
      [bin_count] { return Counts(bin_count); },
      [&count_block](Counts& own, std::ptrdiff_t block) {
        count_block(static_cast<std::size_t>(block), own);
      },
      [&counts](const Counts& own) {
        std::transform(
            own.begin(), own.end(), counts.begin(), counts.begin(), std::plus<>());
      });
  return counts;
}

/** \brief Number of blocks for a number of items; the last block may not be full. */
inline std::size_t
blockCount(std::size_t count, std::size_t block_size)
{
  return (count + block_size - 1) / block_size;
}

/** \brief First item of a block, and one past its last. */
inline std::pair<std::size_t, std::size_t>
blockRange(std::size_t block, std::size_t count, std::size_t block_size)
{
  const std::size_t first = block * block_size;
  return {first, std::min(first + block_size, count)};
}

/** \brief Counts of all pairs per bin, see countBlocks().
 * \param[in] count_pairs called with the first pair of a block, one past its last, and
 * the counts of the calling thread to add to
 */
template <typename CountPairs>
std::vector<std::uint64_t>
countPairs(std::size_t pair_count,
           std::size_t bin_count,
           unsigned int number_of_threads,
           const CountPairs& count_pairs)
{
  return countBlocks(blockCount(pair_count, pair_block_size),
                     bin_count,
                     number_of_threads,
                     [&](std::size_t block, std::vector<std::uint64_t>& own) {
                       const auto [first, last] =
                           blockRange(block, pair_count, pair_block_size);
                       count_pairs(first, last, own);
                     });
}

} // namespace pcl::indoor
