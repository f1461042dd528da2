/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "progress.h"

#include <pcl/console/print.h>

#include <cstdio>
#include <unistd.h> // for isatty

namespace pcl::indoor::tool {

Progress::Progress(bool quiet)
: shown_(!quiet && isatty(STDOUT_FILENO) != 0)
{}

void
Progress::start(const std::string& what)
{
  begin_ = std::chrono::steady_clock::now();
  percent_ = -1;
  if (!shown_)
    return;
  console::print_highlight("%s ", what.c_str());
  std::fflush(stdout);
}

void
Progress::update(std::size_t done, std::size_t all)
{
  if (!shown_ || all == 0)
    return;
  const int percent =
      static_cast<int>(100.0 * static_cast<double>(done) / static_cast<double>(all));
  if (percent == percent_)
    return;
  // the number is written over its predecessor: "\b" moves back without erasing
  std::printf(percent_ < 0 ? "%3d %%" : "\b\b\b\b\b%3d %%", percent);
  percent_ = percent;
  std::fflush(stdout);
}

void
Progress::done(const std::string& result)
{
  if (!shown_)
    return;
  const auto passed = std::chrono::steady_clock::now() - begin_;
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(passed).count();
  if (percent_ >= 0)
    std::printf("\b\b\b\b\b     \b\b\b\b\b");
  console::print_info("[done, ");
  console::print_value("%lld", static_cast<long long>(ms));
  console::print_info(" ms%s%s]\n", result.empty() ? "" : " : ", result.c_str());
  std::fflush(stdout);
}

void
Progress::note(const std::string& text)
{
  if (shown_)
    console::print_info("%s\n", text.c_str());
}

} // namespace pcl::indoor::tool
