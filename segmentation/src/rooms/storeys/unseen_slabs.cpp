/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/storeys/unseen_slabs.h"

#include "rooms/dimensions.h"
#include "rooms/storeys/storey_plan.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace pcl::indoor {
namespace {

/** How many points each layer holds. */
std::vector<std::size_t>
pointsOfLayers(const OccupancyGrid& building)
{
  const int nz = building.grid.shape.nz;
  std::vector<std::size_t> counts(nz, 0);
  for (const std::int32_t cell : building.cells)
    if (cell >= 0)
      ++counts[cell % nz];
  return counts;
}

/** Layers begin ... end - 1. */
struct Band {
  int begin, end;
};

/** The stretches of layers that hold more than a few points, lowest first. */
std::vector<Band>
seenBands(const std::vector<std::size_t>& counts, double few)
{
  std::vector<Band> bands;
  for (int z = 0; z < static_cast<int>(counts.size()); ++z) {
    if (static_cast<double>(counts[z]) <= few)
      continue;
    if (bands.empty() || bands.back().end < z)
      bands.push_back({z, z});
    bands.back().end = z + 1;
  }
  return bands;
}

} // namespace

std::vector<double>
unseenSlabs(const OccupancyGrid& building)
{
  constexpr double hardly = 0.1; // of the points that half of the layers have
  const std::vector<std::size_t> counts = pointsOfLayers(building);
  auto bands = seenBands(counts, hardly * usualCount(counts));
  const int least = voxelsIn(least_height, building.grid.voxel_size, 1);
  bands.erase(
      std::remove_if(bands.begin(),
                     bands.end(),
                     [&](const auto& band) { return band.end - band.begin < least; }),
      bands.end());
  std::vector<double> slabs;
  for (std::size_t k = 1; k < bands.size(); ++k)
    slabs.push_back(0.5 * (bands[k - 1].end + bands[k].begin - 1));
  return slabs;
}

} // namespace pcl::indoor
