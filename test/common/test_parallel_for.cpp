/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <gtest/gtest.h>

#include <pcl/indoor/parallel_for.h>

#include <new>
#include <numeric>
#include <stdexcept>
#include <vector>

using pcl::indoor::evenChunk;
using pcl::indoor::parallelFor;

TEST(ParallelFor, VisitsEachNumberOnce)
{
  for (const int threads : {0, 1, 2, 7})
    for (const std::ptrdiff_t count : {0, 1, 2, 100, 1001})
      for (const std::ptrdiff_t chunk : {std::ptrdiff_t(1),
                                         std::ptrdiff_t(3),
                                         std::ptrdiff_t(5000),
                                         evenChunk(count, threads)}) {
        std::vector<int> visits(count, 0);
        parallelFor(count, threads, chunk, [&](std::ptrdiff_t i) { ++visits[i]; });
        EXPECT_EQ(visits, std::vector<int>(count, 1)) << threads << ' ' << chunk;
      }
}

TEST(ParallelFor, EachThreadHasItsStateAndFinishesAlone)
{
  for (const int threads : {1, 2, 7}) {
    std::ptrdiff_t sum = 0;
    int finished = 0;
    parallelFor(
        1000,
        threads,
        10,
        [] { return std::ptrdiff_t(0); },
        [](std::ptrdiff_t& own, std::ptrdiff_t i) { own += i; },
        [&](std::ptrdiff_t own) {
          sum += own;
          ++finished;
        });
    EXPECT_EQ(sum, 499500);
    EXPECT_LE(finished, threads);
  }
}

TEST(ParallelFor, WhatIsThrownArrivesAtTheCaller)
{
  const auto fail = [] { throw std::runtime_error("no more"); };
  const auto nothing = [](int, std::ptrdiff_t) {};
  for (const int threads : {1, 2, 7}) {
    EXPECT_THROW(parallelFor(100,
                             threads,
                             1,
                             [&](std::ptrdiff_t i) {
                               if (i == 57)
                                 throw std::bad_alloc();
                             }),
                 std::bad_alloc);
    EXPECT_THROW(parallelFor(
                     100,
                     threads,
                     1,
                     [&] {
                       fail();
                       return 0;
                     },
                     nothing),
                 std::runtime_error);
    EXPECT_THROW(parallelFor(
                     100, threads, 1, [] { return 0; }, nothing, [&](int) { fail(); }),
                 std::runtime_error);
  }
}

TEST(ParallelFor, NothingIsBegunAfterAnError)
{
  int visits = 0;
  EXPECT_ANY_THROW(parallelFor(1000, 1, 1, [&](std::ptrdiff_t) {
    ++visits;
    throw std::bad_alloc();
  }));
  EXPECT_EQ(visits, 1);
}
