/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "text/pcl_errors.h"

#include <pcl/console/print.h>

#include <cstdio>
#include <cstdlib>
#include <new>
#include <utility>

namespace pcl::indoor::tool {
namespace {

/** Memory in place of stderr, for errors only; warnings are dropped. */
class ErrorText {
public:
  ErrorText()
  : level_(console::getVerbosityLevel())
  {
    auto* const memory = open_memstream(&text_, &size_);
    if (memory == nullptr)
      throw std::bad_alloc();
    stderr_ = std::exchange(stderr, memory);
    static const int registered = std::atexit(sayAtExit);
    static_cast<void>(registered);
    current_ = this;
    if (level_ > console::L_ERROR)
      console::setVerbosityLevel(console::L_ERROR);
  }

  ~ErrorText()
  {
    console::setVerbosityLevel(level_);
    current_ = nullptr;
    std::fclose(std::exchange(stderr, stderr_));
    std::free(text_);
  }

  ErrorText(const ErrorText&) = delete;
  ErrorText&
  operator=(const ErrorText&) = delete;

  std::string
  get() const
  {
    std::fflush(stderr);
    return std::string(text_, size_);
  }

private:
  /** A library may end the program, as OpenMP does where no thread can be started. */
  static void
  sayAtExit()
  {
    if (current_ == nullptr)
      return;
    std::fflush(stderr);
    const char* text = current_->text_;
    while (*text == '\n')
      ++text;
    std::fputs(text, current_->stderr_);
  }

  static inline const ErrorText* current_ = nullptr;
  console::VERBOSITY_LEVEL level_;
  std::FILE* stderr_ = nullptr;
  char* text_ = nullptr;
  std::size_t size_ = 0;
};

/** "[pcl::Class::function] It is wrong." without what is in brackets. */
std::string
withoutPlace(const std::string& line)
{
  const auto end = line.front() == '[' ? line.find("] ") : line.npos;
  return end == line.npos ? line : line.substr(end + 2);
}

} // namespace

std::string
problemOf(const std::function<void()>& run)
{
  const ErrorText errors;
  run();
  const auto text = errors.get();
  return text.empty() ? text : withoutPlace(text.substr(0, text.find('\n')));
}

} // namespace pcl::indoor::tool
