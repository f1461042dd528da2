/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/available_memory.h"

#include <algorithm>
#include <fstream>
#include <string>

namespace pcl::indoor::tool {
namespace {

/** The number that a file begins with; -1 if there is none. */
double
firstNumber(const std::string& path)
{
  double value = -1;
  return std::ifstream(path) >> value ? value : -1;
}

} // namespace

double
availableMemory()
{
  double available = 0;
  std::ifstream stream("/proc/meminfo");
  for (std::string name, rest; stream >> name && std::getline(stream, rest);)
    if (name == "MemAvailable:")
      available = 1024 * std::stod(rest);
  const double most = firstNumber("/sys/fs/cgroup/memory.max");
  const double used = firstNumber("/sys/fs/cgroup/memory.current");
  return most > 0 && used >= 0 ? std::min(available, std::max(1.0, most - used))
                               : available;
}

} // namespace pcl::indoor::tool
