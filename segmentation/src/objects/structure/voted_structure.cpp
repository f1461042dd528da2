/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/structure/voted_structure.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace {

/** Of the votes for the building. A plane is evidence, too: what lies in one needs
 * fewer of them. */
constexpr double least_in_plane = 0.15, least_of_piece = 0.4;

} // namespace

namespace pcl {
namespace indoor {

void
yieldToVotes(const VoxelClasses& votes, std::vector<std::uint32_t>& plane_of_point)
{
  for (std::size_t i = 0; i < plane_of_point.size(); ++i) {
    const float* const shares = votes.of(i);
    if (std::accumulate(shares, shares + building_classes, 0.0) < least_in_plane)
      plane_of_point[i] = 0;
  }
}

std::vector<StructureKind>
votedStructure(const PieceGraph& graph)
{
  std::vector<StructureKind> kinds(graph.pieces.size(), StructureKind::None);
  if (!graph.has_votes)
    return kinds;
  for (std::size_t p = 0; p < kinds.size(); ++p) {
    const auto& votes = graph.pieces[p].votes.classes;
    const auto end = votes.begin() + building_classes;
    if (std::accumulate(votes.begin(), end, 0.0) >
        least_of_piece * std::accumulate(votes.begin(), votes.end(), 0.0))
      kinds[p] = static_cast<StructureKind>(
          std::max_element(votes.begin(), end) - votes.begin() +
          static_cast<std::ptrdiff_t>(StructureKind::Floor));
  }
  return kinds;
}

} // namespace indoor
} // namespace pcl
