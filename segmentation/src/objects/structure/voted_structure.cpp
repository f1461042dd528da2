/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/structure/voted_structure.h"

#include <cstddef>

namespace pcl::indoor {

void
yieldToVotes(const VoxelClasses& votes, std::vector<std::uint32_t>& plane_of_point)
{
  constexpr double least = 0.15; // of the votes for the building
  for (std::size_t i = 0; i < plane_of_point.size(); ++i)
    if (votes.buildingShare(i) < least)
      plane_of_point[i] = 0;
}

} // namespace pcl::indoor
