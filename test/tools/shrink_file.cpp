/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// To be preloaded (LD_PRELOAD): before the n-th call that reads or maps a file, n being
// the environment's SHRINK_AT, the file SHRINK loses all but its first 300 bytes. With
// a page that is mapped and gone, a program ends by SIGBUS.
#include <cstdlib>
#include <dlfcn.h>
#include <sys/mman.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

void
step()
{
  static int left = std::getenv("SHRINK_AT") ? std::atoi(std::getenv("SHRINK_AT")) : 0;
  if (left > 0 && --left == 0)
    static_cast<void>(truncate(std::getenv("SHRINK"), 300) == 0);
}

template <typename Function>
Function*
next(const char* name, Function*)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" ssize_t
read(int descriptor, void* bytes, std::size_t size)
{
  static auto* const real = next("read", &read);
  step();
  return real(descriptor, bytes, size);
}

extern "C" ssize_t
readv(int descriptor, const iovec* parts, int count)
{
  static auto* const real = next("readv", &readv);
  step();
  return real(descriptor, parts, count);
}

extern "C" void*
mmap(void* address,
     std::size_t size,
     int protection,
     int flags,
     int file,
     off_t begin) noexcept
{
  static auto* const real = next("mmap", &mmap);
  void* const place = real(address, size, protection, flags, file, begin);
  if (file >= 0)
    step(); // after the mapping
  return place;
}
