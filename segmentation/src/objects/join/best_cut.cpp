/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/join/object_joining.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace {

constexpr float agreement = 0.15f; // with the level of a join, in worth

/** Two nodes of the tree of joins that may become one. */
struct Branch {
  std::size_t kept, gone;
  bool is_joined = false; ///< the union is worth more than what is best below it
};

} // namespace

namespace pcl::indoor {

std::vector<std::uint32_t>
bestCut(const std::vector<PieceJoin>& joins,
        const std::vector<float>& worth,
        float level)
{
  assert(worth.size() >= joins.size());
  const auto piece_count = worth.size() - joins.size();
  std::vector<std::size_t> node(piece_count); // that stands for a piece
  std::iota(node.begin(), node.end(), std::size_t(0));
  auto best = worth;
  std::vector<Branch> branches;
  for (const auto& join : joins) {
    const auto own = piece_count + branches.size();
    Branch branch{node[join.kept], node[join.gone]};
    const float apart = best[branch.kept] + best[branch.gone] +
                        (join.level >= level ? -agreement : agreement);
    branch.is_joined = worth[own] >= apart;
    best[own] = std::max(worth[own], apart);
    node[join.kept] = own;
    branches.push_back(branch);
  }
  std::vector<std::size_t> segment(worth.size()); // the highest node that is joined
  std::iota(segment.begin(), segment.end(), std::size_t(0));
  for (std::size_t j = branches.size(); j-- > 0;) {
    const auto own = piece_count + j;
    if (branches[j].is_joined || segment[own] != own)
      segment[branches[j].kept] = segment[branches[j].gone] = segment[own];
  }
  std::vector<std::uint32_t> piece_of_node(worth.size());
  std::iota(piece_of_node.begin(), piece_of_node.begin() + piece_count, 0u);
  for (std::size_t j = 0; j < joins.size(); ++j)
    piece_of_node[piece_count + j] = joins[j].kept;
  std::vector<std::uint32_t> segments;
  for (std::size_t p = 0; p < piece_count; ++p)
    segments.push_back(piece_of_node[segment[p]]);
  return segments;
}

} // namespace pcl::indoor
