/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// To be preloaded (LD_PRELOAD): lets the n-th allocation of a program's main() fail, n
// being the environment's FAIL_AT. With 0, says at the end how many there were. With
// FAIL_FORK in the environment no process can be started.
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <unistd.h>

namespace {

std::atomic<bool> counts{false};
std::atomic<long> allocations{0};
long fail_at = 0;
int (*real_main)(int, char**, char**) = nullptr;

bool
fails()
{
  if (!counts || ++allocations != fail_at)
    return false;
  errno = ENOMEM; // as the real ones do; those who start threads look at it
  return true;
}

int
countedMain(int argc, char** argv, char** environment)
{
  const char* const text = std::getenv("FAIL_AT");
  fail_at = text ? std::atol(text) : 0;
  counts = true;
  const int status = real_main(argc, argv, environment);
  counts = false;
  if (fail_at == 0)
    std::fprintf(stderr, "%ld allocations\n", allocations.load());
  return status;
}

template <typename Function>
Function*
next(const char* name, Function*)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void*
__libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void*
malloc(std::size_t size)
{
  return fails() ? nullptr : __libc_malloc(size);
}

void*
calloc(std::size_t count, std::size_t size)
{
  return fails() ? nullptr : __libc_calloc(count, size);
}

void*
realloc(void* old, std::size_t size)
{
  return fails() ? nullptr : __libc_realloc(old, size);
}

void*
aligned_alloc(std::size_t alignment, std::size_t size)
{
  return fails() ? nullptr : __libc_memalign(alignment, size);
}

int
posix_memalign(void** result, std::size_t alignment, std::size_t size)
{
  if (fails())
    return ENOMEM;
  *result = __libc_memalign(alignment, size);
  return *result == nullptr ? ENOMEM : 0;
}

pid_t
fork()
{
  static auto* const real = next("fork", &fork);
  if (std::getenv("FAIL_FORK") == nullptr)
    return real();
  errno = ENOMEM;
  return -1;
}

int
__libc_start_main(int (*main)(int, char**, char**),
                  int argc,
                  char** argv,
                  void (*init)(),
                  void (*fini)(),
                  void (*rtld_fini)(),
                  void* stack_end)
{
  static auto* const real = next("__libc_start_main", &__libc_start_main);
  real_main = main;
  return real(countedMain, argc, argv, init, fini, rtld_fini, stack_end);
}
}
