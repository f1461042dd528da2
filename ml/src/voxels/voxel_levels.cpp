/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "voxels/voxel_levels.h"

#include <algorithm>
#include <utility>

namespace pcl::indoor {

namespace {

constexpr unsigned axis_bits = 18;
constexpr std::uint64_t axis_mask = (std::uint64_t(1) << axis_bits) - 1;

/** \brief Voxels that have a neighbour there. The keys are ascending, and so are they
 * all with the same number added: both are gone through once. */
RowPairs
neighborsAt(const std::vector<std::uint64_t>& keys, std::uint64_t difference)
{
  RowPairs pairs;
  std::size_t other = 0;
  const auto size = keys.size();
  if (difference >> 63) // below
    while (other < size && keys[other] < keys.front() + difference)
      ++other;
  for (std::size_t v = 0; v < size; ++v) {
    const auto wanted = keys[v] + difference;
    while (other < size && keys[other] < wanted)
      ++other;
    if (other == size)
      break;
    if (keys[other] == wanted) {
      pairs.from.push_back(static_cast<std::uint32_t>(other));
      pairs.to.push_back(static_cast<std::uint32_t>(v));
    }
  }
  return pairs;
}

void
findNeighbors(VoxelLevel& level)
{
  std::size_t tap = 0;
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        level.near[tap++] =
            neighborsAt(level.keys,
                        static_cast<std::uint64_t>(x) +
                            (static_cast<std::uint64_t>(y) << axis_bits) +
                            (static_cast<std::uint64_t>(z) << 2 * axis_bits));
}

/** \brief The keys of the next level; tells the voxels where their parents are. */
std::vector<std::uint64_t>
findParents(VoxelLevel& level)
{
  const auto parentOf = [](std::uint64_t key) {
    return voxelKey((key & axis_mask) / 2,
                    (key >> axis_bits & axis_mask) / 2,
                    (key >> 2 * axis_bits) / 2);
  };
  std::vector<std::uint64_t> parents;
  parents.reserve(level.keys.size());
  for (const auto key : level.keys)
    parents.push_back(parentOf(key));
  std::sort(parents.begin(), parents.end());
  parents.erase(std::unique(parents.begin(), parents.end()), parents.end());
  for (std::size_t v = 0; v < level.keys.size(); ++v) {
    const auto key = level.keys[v];
    const auto place =
        (key >> 2 * axis_bits & 1) * 4 + (key >> axis_bits & 1) * 2 + (key & 1);
    const auto parent = std::lower_bound(parents.begin(), parents.end(), parentOf(key));
    auto& pairs = level.to_parent[place];
    pairs.from.push_back(static_cast<std::uint32_t>(v));
    pairs.to.push_back(static_cast<std::uint32_t>(parent - parents.begin()));
  }
  return parents;
}

} // namespace

std::uint64_t
voxelKey(std::uint64_t x, std::uint64_t y, std::uint64_t z)
{
  return (z << axis_bits | y) << axis_bits | x;
}

std::vector<VoxelLevel>
voxelLevels(std::vector<std::uint64_t> keys, std::size_t count)
{
  std::vector<VoxelLevel> levels(count);
  for (std::size_t k = 0; k < count; ++k) {
    levels[k].keys = std::move(keys);
    findNeighbors(levels[k]);
    if (k + 1 < count)
      keys = findParents(levels[k]);
  }
  return levels;
}

} // namespace pcl::indoor
