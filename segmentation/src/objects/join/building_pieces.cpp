/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/join/building_pieces.h"

#include "objects/structure/voted_structure.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace pcl::indoor {

std::vector<StructureKind>
buildingPieces(const PieceGraph& graph)
{
  std::vector<StructureKind> kinds(graph.pieces.size(), StructureKind::None);
  if (!graph.has_votes)
    return kinds;
  for (std::size_t p = 0; p < kinds.size(); ++p) {
    const auto& votes = graph.pieces[p].votes.classes;
    const auto end = votes.begin() + building_classes;
    if (std::accumulate(votes.begin(), end, 0.0) >
        least_building_share * std::accumulate(votes.begin(), votes.end(), 0.0))
      kinds[p] = static_cast<StructureKind>(
          std::max_element(votes.begin(), end) - votes.begin() +
          static_cast<std::ptrdiff_t>(StructureKind::Floor));
  }
  return kinds;
}

void
leaveAlone(const std::vector<StructureKind>& kinds, PieceGraph& graph)
{
  const auto is_building = [&](std::uint32_t piece) {
    return kinds[piece] != StructureKind::None;
  };
  auto& contacts = graph.contacts;
  contacts.erase(std::remove_if(contacts.begin(),
                                contacts.end(),
                                [&](const auto& contact) {
                                  return is_building(contact.first) ||
                                         is_building(contact.second);
                                }),
                 contacts.end());
}

} // namespace pcl::indoor
