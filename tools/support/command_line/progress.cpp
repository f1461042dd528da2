/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/progress.h"

#include "text/formatted.h"
#include "text/printable.h"

#include <pcl/console/print.h>

#include <cstdio>
#include <unistd.h> // for isatty

namespace pcl::indoor::tool {

Progress::Progress(bool quiet)
: quiet_(quiet)
, shown_(!quiet && isatty(STDOUT_FILENO) != 0)
{}

void
Progress::start(const std::string& what)
{
  begin_ = std::chrono::steady_clock::now();
  percent_ = -1;
  name_ = what;
  text_.clear();
  if (!shown_)
    return;
  console::print_highlight("%s ", printable(what).c_str());
  std::fflush(stdout);
}

void
Progress::update(std::size_t done, std::size_t all, const std::string& detail)
{
  if (!shown_ || all == 0)
    return;
  const int percent =
      static_cast<int>(100.0 * static_cast<double>(done) / static_cast<double>(all));
  if (percent == percent_)
    return;
  if (percent_ < 0)
    first_done_ = done;
  percent_ = percent;
  const double passed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  std::string text = std::to_string(percent) + " %";
  if (passed > 2.0 && done > first_done_ && done < all)
    text += ", " +
            durationText(passed * static_cast<double>(all - done) /
                         static_cast<double>(done - first_done_)) +
            " left";
  if (!detail.empty())
    text += ", " + detail;
  replaceText(text);
}

void
Progress::replaceText(const std::string& text)
{
  // written over its predecessor: a backspace moves back without erasing
  const std::size_t spare = text_.size() > text.size() ? text_.size() - text.size() : 0;
  std::printf("%s%s%s%s",
              std::string(text_.size(), '\b').c_str(),
              text.c_str(),
              std::string(spare, ' ').c_str(),
              std::string(spare, '\b').c_str());
  text_ = text;
  std::fflush(stdout);
}

void
Progress::done(const std::string& result)
{
  const auto passed = std::chrono::steady_clock::now() - begin_;
  stages_.push_back({name_, std::chrono::duration<double>(passed).count()});
  if (!shown_)
    return;
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(passed).count();
  replaceText("");
  console::print_info("[done, ");
  console::print_value("%lld", static_cast<long long>(ms));
  console::print_info(" ms%s%s]\n", result.empty() ? "" : " : ", result.c_str());
  std::fflush(stdout);
}

void
Progress::note(const std::string& text)
{
  if (shown_)
    console::print_info("%s\n", printable(text).c_str());
}

void
Progress::summary(const std::string& text)
{
  if (!quiet_)
    std::printf("%s\n", printable(text).c_str());
}

void
Progress::say(const std::string& text)
{
  if (!quiet_)
    std::fputs(text.c_str(), stderr);
}

void
Progress::table(const TextTable& table)
{
  if (!quiet_)
    std::printf("\n%s", table.text().c_str());
}

std::string
durationText(double seconds)
{
  if (seconds < 60.0)
    return formatted("%.0f s", seconds);
  if (seconds < 3600.0)
    return formatted("%.0f min", seconds / 60.0);
  return formatted("%.1f h", seconds / 3600.0);
}

} // namespace pcl::indoor::tool
