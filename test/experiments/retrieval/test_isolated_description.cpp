/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "retrieval/isolated_description.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>

using pcl::indoor::tool::describeIsolated;

TEST(IsolatedDescription, WhatFailsHasNoHistogramAndTheOthersHaveTheirs)
{
  const auto histograms = describeIsolated(5, [](std::size_t k) {
    if (k == 1)
      std::abort();
    if (k == 3)
      throw std::runtime_error("expected by the test");
    return std::vector<float>(k + 1, static_cast<float>(k));
  });
  ASSERT_EQ(histograms.size(), 5u);
  for (const std::size_t k : {0, 2, 4})
    EXPECT_EQ(histograms[k], std::vector<float>(k + 1, static_cast<float>(k)));
  for (const std::size_t k : {1, 3})
    EXPECT_TRUE(histograms[k].empty());
}

TEST(IsolatedDescription, NoObjectsHaveNoHistograms)
{
  EXPECT_TRUE(
      describeIsolated(0, [](std::size_t) { return std::vector<float>(1); }).empty());
}
