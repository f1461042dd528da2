/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/structure/voted_structure.h"

#include <cstddef>
#include <numeric>

namespace pcl {
namespace indoor {

void
yieldToVotes(const VoxelClasses& votes, std::vector<std::uint32_t>& plane_of_point)
{
  constexpr double least = 0.15; // of the votes for the building
  for (std::size_t i = 0; i < plane_of_point.size(); ++i) {
    const float* const shares = votes.of(i);
    if (std::accumulate(shares, shares + building_classes, 0.0) < least)
      plane_of_point[i] = 0;
  }
}

} // namespace indoor
} // namespace pcl
