/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Loaded before a tool (LD_PRELOAD), it kills the tool before its n-th step on the file
// system that changes something, n = KILL_AT: writing to a file, renaming or removing
// one. Instead of killing it, it sends the signal KILL_BY.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <unistd.h>

namespace {

void
step()
{
  static int left = std::getenv("KILL_AT") ? std::atoi(std::getenv("KILL_AT")) : 0;
  static const char* const signal = std::getenv("KILL_BY");
  if (left > 0 && --left == 0)
    kill(getpid(), signal ? std::atoi(signal) : SIGKILL);
}

template <typename Function>
Function*
next(const char* name, Function*)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" ssize_t
write(int descriptor, const void* bytes, std::size_t size)
{
  static auto* const real = next("write", &write);
  if (descriptor > STDERR_FILENO)
    step();
  return real(descriptor, bytes, size);
}

extern "C" int
rename(const char* from, const char* to) noexcept
{
  static auto* const real = next("rename", &rename);
  step();
  return real(from, to);
}

extern "C" int
unlink(const char* path) noexcept
{
  static auto* const real = next("unlink", &unlink);
  step();
  return real(path);
}
