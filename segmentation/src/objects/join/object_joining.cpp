/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/objects/object_joining.h>

#include "objects/join/joining_features.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>

namespace {

using pcl::indoor::JoiningCriterion;
using pcl::indoor::JoinTree;
using pcl::indoor::PairDescription;
using pcl::indoor::PairSide;
using pcl::indoor::Piece;
using pcl::indoor::PieceContact;
using pcl::indoor::PieceGraph;
using pcl::indoor::PieceShape;
using pcl::indoor::ThingFeatures;

/** What becomes of a thing. */
constexpr std::size_t next_probability = std::tuple_size<ThingFeatures>::value - 2;
constexpr std::size_t next_size = next_probability + 1;

/** Pieces that are joined, each known by one of them. */
class Unions {
public:
  Unions(const PieceGraph& graph, JoiningCriterion& criterion, float least_level)
  : description_(graph)
  , criterion_(criterion)
  , least_level_(least_level)
  , pieces_(graph.pieces)
  , shapes_(graph.pieces.size())
  , version_(graph.pieces.size(), 0)
  , touching_(graph.pieces.size(), 0)
  , contacts_(graph.pieces.size())
  , node_(graph.pieces.size())
  {
    std::iota(node_.begin(), node_.end(), 0u);
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
      if (pieces_[p].positions.count > 0)
        shapes_[p] = description_.shapeOf(pieces_[p]);
    for (const auto& contact : graph.contacts) {
      contacts_[contact.first][contact.second] = contact;
      contacts_[contact.second][contact.first] = contact;
      touching_[contact.first] += contact.first_voxels;
      touching_[contact.second] += contact.second_voxels;
    }
    tree_.things.resize(pieces_.size());
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
      if (pieces_[p].positions.count > 0)
        tree_.things[p] = description_.describeThing(sideOf(p), 1, 1);
    for (const auto& contact : graph.contacts)
      propose(contact.first, contact.second);
  }

  JoinTree
  joinAll()
  {
    float level = 1;
    while (!queue_.empty()) {
      const auto best = queue_.top();
      queue_.pop();
      if (version_[best.a] != best.version_a || version_[best.b] != best.version_b)
        continue; // one of them has grown, or gone
      level = std::min(level, best.probability);
      tree_.joins.push_back({best.a, best.b, level});
      auto &kept = tree_.things[node_[best.a]], &gone = tree_.things[node_[best.b]];
      kept[next_probability] = gone[next_probability] = best.probability;
      kept[next_size] = gone.front() - kept.front(); // their log areas
      gone[next_size] = -kept[next_size];
      join(best.a, best.b);
      node_[best.a] = static_cast<std::uint32_t>(tree_.things.size());
      tree_.things.push_back(
          description_.describeThing(sideOf(best.a), best.probability, level));
      for (const auto& entry : contacts_[best.a])
        propose(best.a, entry.first);
    }
    return std::move(tree_);
  }

private:
  struct Proposal {
    float probability;
    std::uint32_t a, b; ///< a < b
    std::uint32_t version_a, version_b;

    /** The most probable first; of equal ones that of the smaller numbers. */
    bool
    operator<(const Proposal& other) const
    {
      return std::make_tuple(-probability, a, b) >
             std::make_tuple(-other.probability, other.a, other.b);
    }
  };

  void
  propose(std::uint32_t a, std::uint32_t b)
  {
    if (std::make_pair(pieces_[a].positions.count, a) >
        std::make_pair(pieces_[b].positions.count, b))
      std::swap(a, b);
    auto contact = contacts_[a].at(b);
    if (contact.first != a) {
      std::swap(contact.first, contact.second);
      std::swap(contact.first_voxels, contact.second_voxels);
    }
    const auto features = description_.describe(sideOf(a), sideOf(b), contact);
    const float probability = criterion_.probability(features, a, b);
    const auto first = std::min(a, b), second = std::max(a, b);
    if (probability >= least_level_) {
      queue_.push({probability, first, second, version_[first], version_[second]});
      return;
    }
    for (const auto piece : {a, b}) { // it stays so if nothing else takes it up
      auto& next = tree_.things[node_[piece]][next_probability];
      next = std::max(next, probability);
    }
  }

  PairSide
  sideOf(std::uint32_t piece) const
  {
    return {pieces_[piece],
            shapes_[piece],
            touching_[piece],
            static_cast<double>(contacts_[piece].size())};
  }

  /** The second goes up in the first. */
  void
  join(std::uint32_t kept, std::uint32_t gone)
  {
    criterion_.joined(kept, gone);
    const auto between = contacts_[kept].at(gone);
    touching_[kept] += touching_[gone] - between.first_voxels - between.second_voxels;
    pieces_[kept] += pieces_[gone];
    shapes_[kept] = description_.shapeOf(pieces_[kept]);
    ++version_[kept];
    ++version_[gone];
    std::map<std::uint32_t, PieceContact> moved;
    moved.swap(contacts_[gone]);
    moved.erase(kept);
    contacts_[kept].erase(gone);
    for (auto& [other, contact] : moved) {
      (contact.first == gone ? contact.first : contact.second) = kept;
      const auto found = contacts_[kept].find(other);
      if (found != contacts_[kept].end())
        contact += found->second;
      contacts_[kept][other] = contact;
      contacts_[other].erase(gone);
      contacts_[other][kept] = contact;
    }
  }

  PairDescription description_;
  JoiningCriterion& criterion_;
  float least_level_;
  std::vector<Piece> pieces_;
  std::vector<PieceShape> shapes_;
  std::vector<std::uint32_t> version_;
  std::vector<double> touching_; ///< voxels that touch others, some more than once
  std::vector<std::map<std::uint32_t, PieceContact>> contacts_; // by the other piece
  JoinTree tree_;
  std::vector<std::uint32_t> node_; ///< the thing that each piece stands for
  std::priority_queue<Proposal> queue_;
};

} // namespace

namespace pcl {
namespace indoor {

JoinTree
joinPieces(const PieceGraph& graph, JoiningCriterion& criterion, float least_level)
{
  return Unions(graph, criterion, least_level).joinAll();
}

std::vector<std::uint32_t>
segmentsAtLevel(std::size_t piece_count,
                const std::vector<PieceJoin>& joins,
                float level)
{
  std::vector<std::uint32_t> parent(piece_count);
  std::iota(parent.begin(), parent.end(), 0u);
  const auto find = [&](std::uint32_t piece) {
    while (parent[piece] != piece)
      piece = parent[piece] = parent[parent[piece]];
    return piece;
  };
  for (const auto& join : joins) {
    if (join.level < level)
      break;
    parent[find(join.gone)] = find(join.kept);
  }
  for (std::uint32_t p = 0; p < piece_count; ++p)
    parent[p] = find(p);
  return parent;
}

} // namespace indoor
} // namespace pcl
