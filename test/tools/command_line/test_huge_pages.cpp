/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// The operators of tools/support/command_line/huge_pages.cpp are this program's own

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <new>
#include <vector>

namespace {

constexpr std::size_t huge_page = std::size_t{1} << 21;
volatile std::size_t too_much = std::numeric_limits<std::size_t>::max() / 4;

} // namespace

#if !defined(__SANITIZE_ADDRESS__)

TEST(HugePages, LargeBlocksBeginWithOne)
{
  for (const std::size_t size : {huge_page, huge_page + 1, 5 * huge_page + 12345}) {
    std::vector<char> block(size, 'a');
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block.data()) % huge_page, 0u) << size;
    block.resize(2 * size, 'b'); // moved
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block.data()) % huge_page, 0u) << size;
    EXPECT_EQ(block[size - 1], 'a');
    EXPECT_EQ(block[size], 'b');
  }
}

TEST(HugePages, TheHandlerIsAskedUntilItGivesUp)
{
  static int asked = 0;
  std::set_new_handler([] {
    if (++asked == 3)
      std::set_new_handler(nullptr);
  });
  EXPECT_THROW(::operator delete(::operator new(too_much)), std::bad_alloc);
  EXPECT_EQ(asked, 3);
}

#endif

TEST(HugePages, NothingAndTooMuchAreAskedForAsEver)
{
  void* nothing = ::operator new(0);
  EXPECT_NE(nothing, nullptr);
  ::operator delete(nothing);
  EXPECT_THROW(::operator delete(::operator new(too_much)), std::bad_alloc);
  EXPECT_EQ(::operator new(too_much, std::nothrow), nullptr);
}
