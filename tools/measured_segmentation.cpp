/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "measured_segmentation.h"

#include "options.h" // for ToolError
#include "pipe_transfer.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace pcl::indoor::tool {
namespace {

constexpr int reported = 2; // exit status: stderr says why

double
peakMegabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/** What the child does. \return its exit status */
int
runInChild(int output, const std::function<std::vector<std::uint32_t>()>& segment)
{
  try {
    MeasuredSegmentation result;
    const double before = peakMegabytes();
    const auto begin = std::chrono::steady_clock::now();
    result.labels = segment();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    double numbers[] = {time.count(), peakMegabytes() - before};
    std::uint64_t size = result.labels.size();
    const bool written =
        transfer(output, numbers, sizeof(numbers), true) &&
        transfer(output, &size, sizeof(size), true) &&
        transfer(
            output, result.labels.data(), size * sizeof(result.labels.front()), true);
    return written ? 0 : 1;
  } catch (const AlreadyReported&) {
    return reported;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return reported;
  }
}

} // namespace

MeasuredSegmentation
segmentMeasured(const std::function<std::vector<std::uint32_t>()>& segment)
{
  std::fflush(nullptr); // or the child would print it again
  int ends[2];
  if (pipe(ends) != 0)
    throw ToolError("a child process cannot be started: no pipe");
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    _exit(runInChild(ends[1], segment));
  }
  close(ends[1]);
  MeasuredSegmentation result;
  double numbers[2] = {0, 0};
  std::uint64_t size = 0;
  bool whole = child > 0 && transfer(ends[0], numbers, sizeof(numbers), false) &&
               transfer(ends[0], &size, sizeof(size), false);
  if (whole) {
    result.labels.resize(size);
    whole = transfer(
        ends[0], result.labels.data(), size * sizeof(result.labels.front()), false);
  }
  close(ends[0]);
  if (child < 0)
    throw ToolError("a child process cannot be started");
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == reported)
    throw AlreadyReported();
  if (!whole)
    throw ToolError("the segmentation ended early");
  result.seconds = numbers[0];
  result.megabytes = numbers[1];
  return result;
}

} // namespace pcl::indoor::tool
