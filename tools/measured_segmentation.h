/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Labels, and what it took to find them. */
struct MeasuredSegmentation {
  std::vector<std::uint32_t> labels;
  double seconds = 0;
  double megabytes = 0; ///< most that was in use at a time, beyond the cloud
};

/** \brief Run a segmentation in a process of its own, so that its memory is its own.
 * To be called before this process has used several threads: a child has only one of
 * them, and waits for the others for ever.
 * \throws ToolError if the process cannot be started or ends early
 * \throws AlreadyReported if the segmentation threw that
 */
MeasuredSegmentation
segmentMeasured(const std::function<std::vector<std::uint32_t>()>& segment);

} // namespace pcl::indoor::tool
