/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"
#include "segmentation/object_settings.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief What pcl_noise_resilient_lccp finds, in the order of the points. */
struct SegmentedObjects {
  std::vector<std::uint32_t> object_of_point;    ///< 0 = not finite or an outlier
  std::vector<std::uint32_t> structure_of_point; ///< 1 floor, 2 wall, 3 ceiling, 4
                                                 ///< remainder, 0 anything else
  std::uint32_t count = 0;                       ///< of objects
};

/** \brief Find the objects of a room.
 * \param[in] warn is told what is implausible, a line each
 * \throws ToolError if nothing can be found, or points lack colours that are wanted
 */
SegmentedObjects
segmentObjects(const ObjectSettings& settings,
               const CloudFile& file,
               const std::function<void(const std::string& line)>& warn);

} // namespace pcl::indoor::tool
