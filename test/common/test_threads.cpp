/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/exceptions.h>
#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

// Compiled without OpenMP, as the code of a user may be: the library's functions have
// threads all the same.
#ifdef _OPENMP
#error "This test needs -fno-openmp."
#endif

using pcl::indoor::parallelFor;
using pcl::indoor::threadCount;
using pcl::indoor::usefulThreads;

TEST(Threads, AreAsManyAsRequested)
{
  EXPECT_EQ(threadCount(7), 7);
  EXPECT_EQ(threadCount(7u), 7);
  EXPECT_GE(threadCount(0), 1);
  EXPECT_EQ(threadCount(0u), threadCount(0));
  EXPECT_EQ(threadCount(5000), 1024) << "each needs memory for its stack";
  EXPECT_EQ(threadCount(4000000000u), 1024);
  EXPECT_THROW(threadCount(-1), pcl::BadArgumentException);
}

TEST(Threads, AreNoMoreThanTheWorkIsWorth)
{
  EXPECT_EQ(usefulThreads(7, 0, 10), 1);
  EXPECT_EQ(usefulThreads(7, 25, 10), 3);
  EXPECT_EQ(usefulThreads(7, 1000, 10), 7);
  EXPECT_EQ(usefulThreads(-1, 0, 10), 1);
}

TEST(Threads, OfALoopWorkAtTheSameTime)
{
  constexpr int count = 3;
  std::atomic<int> waiting(0);
  parallelFor(count, count, 1, [&](std::ptrdiff_t) {
    ++waiting;
    for (int round = 0; waiting < count && round < 5000; ++round) // 5 s
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(waiting, count);
  });
}
