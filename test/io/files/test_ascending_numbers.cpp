/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/ascending_numbers.h"

#include <gtest/gtest.h>

#include <random>

using namespace pcl::indoor::tool;

TEST(AscendingNumbers, GivesBackWhatWasAdded)
{
  std::mt19937_64 random(3);
  std::vector<std::uint64_t> expected = {0, 0, 127, 255, 256, 16639, 1ull << 62};
  for (int i = 0; i < 1000; ++i)
    expected.push_back(expected.back() + (random() >> (20 + random() % 44)));
  AscendingNumbers numbers;
  for (const auto number : expected)
    numbers.add(number);
  numbers.shrink();
  AscendingNumbers::Reader reader(numbers);
  for (const auto number : expected) {
    ASSERT_TRUE(reader.next());
    ASSERT_EQ(reader.number(), number);
  }
  EXPECT_FALSE(reader.next());
}

TEST(AscendingNumbers, Empty)
{
  const AscendingNumbers numbers;
  EXPECT_FALSE(AscendingNumbers::Reader(numbers).next());
}
