/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/console/print.h>

#include <iostream>
#include <mutex>
#include <streambuf>

namespace pcl::indoor::tool {

/** Keeps PCL's readers and writers, which print what they also return, silent for as
 * long as one of these lives, in any thread. */
class SilentPcl {
public:
  SilentPcl()
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if (users++ > 0)
      return;
    level = console::getVerbosityLevel();
    cerr = std::cerr.rdbuf(nullptr);
    console::setVerbosityLevel(console::L_ALWAYS);
  }

  ~SilentPcl()
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if (--users > 0)
      return;
    std::cerr.rdbuf(cerr);
    console::setVerbosityLevel(level);
  }

  SilentPcl(const SilentPcl&) = delete;
  SilentPcl&
  operator=(const SilentPcl&) = delete;

private:
  // of the whole program, as what they keep is
  inline static std::mutex mutex;
  inline static int users = 0;
  inline static console::VERBOSITY_LEVEL level = console::L_INFO;
  inline static std::streambuf* cerr = nullptr;
};

} // namespace pcl::indoor::tool
