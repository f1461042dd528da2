/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "comparison/measured_segmentation.h"
#include "files/tool_error.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

using namespace pcl::indoor::tool;

TEST(SegmentMeasured, ReturnsLabelsTimeAndMemory)
{
  const std::vector<std::uint32_t> expected{3, 1, 4, 1, 5};
  const auto result = segmentMeasured([&] {
    std::vector<char> block(64 << 20, 1); // touched, so that it is in use
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return block[12345] ? expected : std::vector<std::uint32_t>();
  });
  EXPECT_EQ(result.labels, expected);
  EXPECT_GE(result.seconds, 0.05);
  EXPECT_GT(result.megabytes, 60);
  EXPECT_LT(result.megabytes, 80);
  const auto small = segmentMeasured([] { return std::vector<std::uint32_t>(); });
  EXPECT_TRUE(small.labels.empty());
  EXPECT_LT(small.megabytes, 20) << "the memory of one run is not that of the next";
}

TEST(SegmentMeasured, FailuresAreNoticed)
{
  testing::internal::CaptureStderr();
  const auto aborted = segmentMeasured([]() -> std::vector<std::uint32_t> {
    std::fputs("file.cpp:714: an assertion of a library\n", stderr);
    std::abort();
  });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(aborted.problem, "stopped by the signal Aborted");
  EXPECT_TRUE(aborted.labels.empty());
  const auto thrown = segmentMeasured([]() -> std::vector<std::uint32_t> {
    throw std::runtime_error("expected by the test");
  });
  EXPECT_EQ(thrown.problem, "expected by the test");
}
