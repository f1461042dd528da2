/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/unfinished_files.h"

#include <atomic>
#include <cerrno>  // for program_invocation_short_name
#include <climits> // for PATH_MAX
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <unistd.h> // for getpid, unlink

namespace pcl::indoor::tool {
namespace {

// A signal's handler may neither allocate nor lock: a fixed table is all it can read.
// What is beyond it stays in place when a signal comes.
struct Slot {
  std::atomic<pid_t> owner{0}; // 0: free; a child process removes none of its parent's
  char path[PATH_MAX];
};
constexpr int slot_count = 16;
Slot slots[slot_count];
// The handler sets ending, SignalPause sets paused; whichever sees the other's flag
// waits.
std::atomic<bool> paused{false};
std::atomic<bool> ending{false};
std::atomic<int> waiting{0}; // the signal that came during a pause
static_assert(std::atomic<pid_t>::is_always_lock_free);

void
removeAll()
{
  for (const auto& slot : slots)
    if (slot.owner == getpid())
      unlink(slot.path);
}

void
endBy(int signal)
{
  std::signal(signal, SIG_DFL);
  raise(signal);
}

extern "C" void
removeUnfinishedAndEnd(int signal)
{
  ending = true;
  if (paused) {
    waiting = signal;
    ending = false;
    return;
  }
  removeAll();
  endBy(signal);
}

/** \brief The end of a program that does not catch what was thrown, for example before
 * the options are read, or by a destructor. Allocates nothing. */
[[noreturn]] void
endWithMessage()
{
  removeAll();
  const char* problem = "an error of the program";
  try {
    if (std::current_exception())
      throw;
  } catch (const std::bad_alloc&) {
    problem = "There is not enough memory.";
  } catch (const std::exception& error) {
    problem = error.what();
  } catch (...) {
  }
  dprintf(STDERR_FILENO, "[%s] %s\n", program_invocation_short_name, problem);
  std::_Exit(EXIT_FAILURE);
}

[[maybe_unused]] const auto previous = std::set_terminate(endWithMessage);

} // namespace

void
prepareForWriting()
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction present {};
    if (sigaction(signal, nullptr, &present) != 0 || present.sa_handler != SIG_DFL)
      continue; // ignored, as by nohup, or treated by the program
    struct sigaction action {};
    action.sa_handler = removeUnfinishedAndEnd;
    sigaction(signal, &action, nullptr);
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool
addUnfinished(const std::string& path)
{
  Slot* free = nullptr;
  for (auto& slot : slots) {
    if (slot.owner == getpid() && path == slot.path)
      return false;
    if (slot.owner != getpid() && free == nullptr)
      free = &slot;
  }
  if (free != nullptr && path.size() < PATH_MAX) {
    std::memcpy(free->path, path.c_str(), path.size() + 1);
    free->owner = getpid();
  }
  return true;
}

void
removeUnfinished(const std::string& path)
{
  for (auto& slot : slots)
    if (slot.owner == getpid() && path == slot.path)
      slot.owner = 0;
}

SignalPause::SignalPause()
{
  paused = true;
  while (ending) // by a handler in another thread
    usleep(1000);
}

SignalPause::~SignalPause()
{
  paused = false;
  if (const int signal = waiting.exchange(0))
    endBy(signal);
}

} // namespace pcl::indoor::tool
