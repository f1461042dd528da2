/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "text/pcl_errors.h"

#include <pcl/console/print.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <new>
#include <sys/types.h> // for ssize_t
#include <utility>
#include <vector>

namespace pcl::indoor::tool {
namespace {

/** What one thread prints on stderr, of which there is one for all threads: while any
 * of these lives, a stream that tells them apart is in its place. Errors only; warnings
 * are dropped. */
class ErrorText {
public:
  ErrorText()
  : outer_(of_thread_)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (alive_.empty())
      takeStderr();
    alive_.push_back(this);
    of_thread_ = this;
  }

  ~ErrorText()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    of_thread_ = outer_;
    alive_.erase(std::find(alive_.begin(), alive_.end(), this));
    if (!alive_.empty())
      return;
    console::setVerbosityLevel(level_);
    stderr = real_;
  }

  ErrorText(const ErrorText&) = delete;
  ErrorText&
  operator=(const ErrorText&) = delete;

  std::string
  get() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return text_;
  }

private:
  static void
  takeStderr()
  {
    // never closed: a thread that prints may still hold it
    static std::FILE* const stream =
        fopencookie(nullptr, "w", {nullptr, receive, nullptr, nullptr});
    if (stream == nullptr)
      throw std::bad_alloc();
    static const int registered = std::atexit(sayAtExit);
    static_cast<void>(registered);
    std::setvbuf(stream, nullptr, _IONBF, 0); // each thread writes for itself
    real_ = std::exchange(stderr, stream);
    level_ = console::getVerbosityLevel();
    if (level_ > console::L_ERROR)
      console::setVerbosityLevel(console::L_ERROR);
  }

  /** What a thread prints that has no text of its own, one of OpenMP's perhaps, is the
   * last one's. */
  static ssize_t
  receive(void* /*cookie*/, const char* bytes, std::size_t size)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    auto* const text = of_thread_ != nullptr ? of_thread_
                       : alive_.empty()      ? nullptr
                                             : alive_.back();
    try {
      if (text != nullptr)
        text->text_.append(bytes, size);
      else
        std::fwrite(bytes, 1, size, real_);
    } catch (const std::bad_alloc&) { // of the text less is known
    }
    return static_cast<ssize_t>(size);
  }

  /** A library may end the program, as OpenMP does where no thread can be started. */
  static void
  sayAtExit()
  {
    for (const auto* text : alive_) {
      const auto begin = text->text_.find_first_not_of('\n');
      if (begin != std::string::npos)
        std::fputs(text->text_.c_str() + begin, real_);
    }
  }

  static inline std::mutex mutex_; // of all that follows, but the thread's own
  static inline std::vector<ErrorText*> alive_;
  static inline std::FILE* real_ = nullptr;
  static inline console::VERBOSITY_LEVEL level_ = console::L_INFO;
  static inline thread_local ErrorText* of_thread_ = nullptr;

  ErrorText* outer_;
  std::string text_;
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
