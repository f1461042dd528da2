/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstdint>
#include <string>

namespace pcl::indoor::tool {

class OptionParser;

/** \brief The option -memory_limit: a scan that needs more memory is refused before it
 * is read, since the system ends programs that take too much without a word. */
class MemoryLimit {
public:
  void
  addOption(OptionParser& parser);

  /** \brief Compare the limit with what a tool will need, from the header of the scan.
   * \param[in] bytes_per_point measured, see docs/experiments/robustness.md
   * \param[in] points that are in memory at once; 0 = all that the file promises
   * \throws ToolError naming need, limit and what can be done
   */
  void
  require(const std::string& path,
          double bytes_per_point,
          std::uint64_t points = 0) const;

private:
  double gigabytes_ = 0.0; ///< 0: what is available
};

} // namespace pcl::indoor::tool
