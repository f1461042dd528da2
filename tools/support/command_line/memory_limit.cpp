/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/memory_limit.h"

#include "command_line/options.h"
#include "files/available_memory.h"
#include "files/cloud_formats.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl::indoor::tool {
namespace {

constexpr double gigabyte = 1e9;
constexpr double base = 0.05 * gigabyte; // of a tool with its libraries

/** To a tenth, which is printed in full; 0 would mean unknown. */
double
roundedDown(double gigabytes)
{
  return gigabytes > 0 ? std::max(0.1, std::floor(10 * gigabytes) / 10) : 0;
}

} // namespace

void
MemoryLimit::addOption(OptionParser& parser)
{
  parser.number("-memory_limit",
                gigabytes_,
                "scans that need more memory are refused, 0 = automatic: more than is "
                "available now; a large number refuses none",
                "GB",
                Range::atLeast(0));
}

void
MemoryLimit::require(const std::string& path,
                     double bytes_per_point,
                     std::uint64_t points) const
{
  points = points > 0 ? points : promisedPoints(path);
  const double needed =
      (base + static_cast<double>(points) * bytes_per_point) / gigabyte;
  const double available = roundedDown(availableMemory() / gigabyte);
  const double limit = gigabytes_ > 0 ? gigabytes_ : available;
  if (limit == 0 || needed <= limit)
    return;
  std::ostringstream text;
  text.precision(2);
  text << std::fixed << path << ": its " << points << " points need about " << needed
       << " GB of memory, the limit is " << limit
       << " GB; thin them out (pcl_voxel_grid), cut the scan into parts, or raise "
          "-memory_limit";
  throw ToolError(text.str());
}

} // namespace pcl::indoor::tool
