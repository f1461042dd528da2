/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Labels, and what it took to find them. */
struct MeasuredSegmentation {
  std::vector<std::uint32_t> labels;
  double seconds = 0;
  double megabytes = 0; ///< most that was in use at a time, beyond the cloud
  std::string problem;  ///< how it ended before it was done; empty: it did not
};

/** \brief Run a segmentation in a process of its own, so that its memory is its own.
 * To be called before this process has used several threads: a child has only one of
 * them, and waits for the others for ever.
 * Where it throws, the result has what it said on stderr as its problem, and where it
 * crashes, how it ended; stderr itself stays empty.
 * \throws ToolError if the process cannot be started
 */
MeasuredSegmentation
segmentMeasured(const std::function<std::vector<std::uint32_t>()>& segment);

} // namespace pcl::indoor::tool
