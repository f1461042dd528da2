/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "comparison/measured_segmentation.h"

#include "comparison/pipe_transfer.h"
#include "files/tool_error.h"
#include "text/printable.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <memory>

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
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", printable(messageOf(error)).c_str());
    return reported;
  }
}

/** What the child has said on stderr, but for the last line feed. */
std::string
textOf(std::FILE* said)
{
  std::string text;
  std::rewind(said);
  for (int letter = std::fgetc(said); letter != EOF; letter = std::fgetc(said))
    text += static_cast<char>(letter);
  while (!text.empty() && text.back() == '\n')
    text.pop_back();
  return text;
}

/** What the child sends. \return false if it is not complete */
bool
receive(int input, MeasuredSegmentation& result)
{
  double numbers[2] = {0, 0};
  std::uint64_t size = 0;
  if (!transfer(input, numbers, sizeof(numbers), false) ||
      !transfer(input, &size, sizeof(size), false))
    return false;
  result.seconds = numbers[0];
  result.megabytes = numbers[1];
  result.labels.resize(size);
  return transfer(
      input, result.labels.data(), size * sizeof(result.labels.front()), false);
}

std::string
endOf(int status)
{
  return WIFSIGNALED(status)
             ? std::string("stopped by the signal ") + strsignal(WTERMSIG(status))
             : "ended with status " + std::to_string(WEXITSTATUS(status));
}

} // namespace

MeasuredSegmentation
segmentMeasured(const std::function<std::vector<std::uint32_t>()>& segment)
{
  std::fflush(nullptr); // or the child would print it again
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> said(std::tmpfile(),
                                                             std::fclose);
  int ends[2];
  if (!said || pipe(ends) != 0)
    throw ToolError("a child process cannot be started: no pipe or no temporary file");
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    dup2(fileno(said.get()), STDERR_FILENO);
    _exit(runInChild(ends[1], segment));
  }
  close(ends[1]);
  MeasuredSegmentation result;
  const bool whole = child > 0 && receive(ends[0], result);
  close(ends[0]);
  if (child < 0)
    throw ToolError("a child process cannot be started");
  int status = 0;
  waitpid(child, &status, 0);
  if (!whole) {
    result = MeasuredSegmentation();
    result.problem = WIFEXITED(status) && WEXITSTATUS(status) == reported
                         ? textOf(said.get())
                         : endOf(status);
  }
  return result;
}

} // namespace pcl::indoor::tool
