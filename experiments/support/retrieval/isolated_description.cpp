/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "retrieval/isolated_description.h"

#include "comparison/pipe_transfer.h"
#include "files/tool_error.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>

namespace pcl::indoor::tool {
namespace {

/** \brief What the child does; its objects' descriptions go through a pipe.
 * \return whether all of them arrived */
bool
describeInto(int output,
             std::size_t first,
             std::size_t object_count,
             const std::function<std::vector<float>(std::size_t)>& describe)
{
  const int null = open("/dev/null", O_WRONLY); // the assertion's text
  if (null >= 0)
    dup2(null, STDERR_FILENO);
  for (std::size_t k = first; k < object_count; ++k) {
    std::vector<float> histogram = describe(k);
    std::uint64_t size = histogram.size();
    if (!transfer(output, &size, sizeof(size), true) ||
        !transfer(output, histogram.data(), size * sizeof(float), true))
      return false;
  }
  return true;
}

/** \brief The child's whole life: what it throws must not run the parent's code. */
[[noreturn]] void
describeAndExit(int output,
                std::size_t first,
                std::size_t object_count,
                const std::function<std::vector<float>(std::size_t)>& describe)
{
  bool done = false;
  try {
    done = describeInto(output, first, object_count, describe);
  } catch (...) { // the parent sees that a description is missing
  }
  _exit(done ? 0 : 1);
}

} // namespace

std::vector<std::vector<float>>
describeIsolated(std::size_t object_count,
                 const std::function<std::vector<float>(std::size_t k)>& describe)
{
  std::vector<std::vector<float>> histograms;
  std::fflush(nullptr); // or the child would print it again
  while (histograms.size() < object_count) {
    int ends[2];
    if (pipe(ends) != 0)
      throw ToolError("a child process cannot be started: no pipe");
    const pid_t child = fork();
    if (child == 0) {
      close(ends[0]);
      describeAndExit(ends[1], histograms.size(), object_count, describe);
    }
    close(ends[1]);
    std::uint64_t size = 0;
    while (child > 0 && transfer(ends[0], &size, sizeof(size), false)) {
      std::vector<float> histogram(size);
      if (!transfer(ends[0], histogram.data(), size * sizeof(float), false))
        break;
      histograms.push_back(std::move(histogram));
    }
    close(ends[0]);
    if (child < 0)
      throw ToolError("a child process cannot be started");
    waitpid(child, nullptr, 0);
    if (histograms.size() < object_count)
      histograms.emplace_back();
  }
  return histograms;
}

} // namespace pcl::indoor::tool
