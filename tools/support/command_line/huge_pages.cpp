/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

// The memory of tools that work on millions of points: what is large lies in pages of
// 2 MiB in place of 4 KiB, where the system gives such pages to those who ask. These
// operators take the place of the C++ library's in each program that this file is
// compiled into, and in the libraries that it loads. Sanitizers bring operators of
// their own.
#if !defined(__SANITIZE_ADDRESS__)

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace {

void*
allocate(std::size_t size)
{
  constexpr std::size_t huge_page = std::size_t{1} << 21; // bytes
  if (size < huge_page)
    return std::malloc(size > 0 ? size : 1);
  void* memory = nullptr;
  if (posix_memalign(&memory, huge_page, size) != 0)
    return nullptr;
#ifdef MADV_HUGEPAGE
  madvise(memory, size, MADV_HUGEPAGE); // a wish: without, it is as slow as ever
#endif
  return memory;
}

} // namespace

void*
operator new(std::size_t size)
{
  for (;;) {
    if (void* memory = allocate(size))
      return memory;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr)
      throw std::bad_alloc();
    handler();
  }
}

void
operator delete(void* memory) noexcept
{
  std::free(memory);
}

void
operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

#endif
