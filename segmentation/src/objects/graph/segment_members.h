/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** The points or voxels of a segment, by their indices. */
using SegmentMembers = std::vector<std::uint32_t>;

/** The members of each number of a segment, ascending; those that are left out do not
 * count. REQUIRES: at least one. */
inline std::vector<SegmentMembers>
membersOfSegments(const std::vector<std::uint8_t>& left_out,
                  const std::vector<std::uint32_t>& segments)
{
  std::vector<SegmentMembers> members(
      1 + *std::max_element(segments.begin(), segments.end()));
  for (std::uint32_t i = 0; i < segments.size(); ++i)
    if (!left_out[i])
      members[segments[i]].push_back(i);
  return members;
}

} // namespace pcl::indoor
