/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/join/object_joining.h"

#include "objects/join/joining_features.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>

namespace {

using pcl::indoor::JoiningCriterion;
using pcl::indoor::JoinTree;
using pcl::indoor::next_probability;
using pcl::indoor::next_size;
using pcl::indoor::ObjectFeatures;
using pcl::indoor::PairDescription;
using pcl::indoor::PairSide;
using pcl::indoor::Piece;
using pcl::indoor::PieceContact;
using pcl::indoor::PieceGraph;
using pcl::indoor::PieceShape;

/** A piece with more contacts, as a floor that was not told from the objects on it, is
 * described anew only when it has grown by a share: else n joins with it would describe
 * n contacts each. Rooms have at most 40 contacts, buildings in one piece had 372. */
constexpr std::size_t most_contacts = 512;
constexpr double least_growth = 1.0 / 8;

/** Pieces that are joined. A union lives in the place of that with more contacts, and
 * is known by the smallest of its pieces. */
class Unions {
public:
  Unions(const PieceGraph& graph, JoiningCriterion& criterion, float least_level)
  : description_(graph)
  , criterion_(criterion)
  , least_level_(least_level)
  , pieces_(graph.pieces)
  , shapes_(graph.pieces.size())
  , described_size_(graph.pieces.size(), 0)
  , touching_(graph.pieces.size(), 0)
  , links_(graph.pieces.size())
  , name_(graph.pieces.size())
  {
    std::iota(name_.begin(), name_.end(), 0u);
    node_ = name_;
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
      if (pieces_[p].positions.count > 0)
        shapes_[p] = description_.shapeOf(pieces_[p]);
    for (const auto& contact : graph.contacts) {
      links_[contact.first][contact.second].contact = contact;
      links_[contact.second][contact.first].contact = contact;
      touching_[contact.first] += contact.first_voxels;
      touching_[contact.second] += contact.second_voxels;
    }
    tree_.objects.resize(pieces_.size());
    for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
      described_size_[p] = pieces_[p].positions.count;
      if (pieces_[p].positions.count > 0)
        tree_.objects[p] = description_.describeObject(sideOf(p), 1, 1);
    }
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
      if (!isValid(best))
        continue; // one of them has grown, or gone
      level = std::min(level, best.probability);
      join(best, level);
    }
    return std::move(tree_);
  }

private:
  struct Proposal {
    float probability;
    std::uint32_t name_a, name_b; ///< a < b
    std::uint32_t a, b;           ///< where they live
    std::uint64_t number;

    /** The most probable first; of equal ones that of the smaller numbers. */
    bool
    operator<(const Proposal& other) const
    {
      return std::make_tuple(-probability, name_a, name_b) >
             std::make_tuple(-other.probability, other.name_a, other.name_b);
    }
  };

  struct Link {
    PieceContact contact;     ///< between places
    std::uint64_t number = 0; ///< of the proposal that holds
  };

  using Links = std::map<std::uint32_t, Link>; // by the other place

  bool
  isValid(const Proposal& proposal) const
  {
    const auto link = links_[proposal.a].find(proposal.b);
    return link != links_[proposal.a].end() && link->second.number == proposal.number;
  }

  void
  propose(std::uint32_t a, std::uint32_t b)
  {
    if (std::make_pair(pieces_[a].positions.count, name_[a]) >
        std::make_pair(pieces_[b].positions.count, name_[b]))
      std::swap(a, b);
    auto& link = links_[a].at(b);
    auto contact = link.contact;
    if (contact.first != a) {
      std::swap(contact.first, contact.second);
      std::swap(contact.first_voxels, contact.second_voxels);
    }
    const auto features = description_.describe(sideOf(a), sideOf(b), contact);
    const float probability = criterion_.probability(features, name_[a], name_[b]);
    link.number = links_[b].at(a).number = ++last_number_;
    if (probability >= least_level_) {
      if (name_[a] > name_[b])
        std::swap(a, b);
      queue_.push({probability, name_[a], name_[b], a, b, last_number_});
      return;
    }
    for (const auto piece : {a, b}) { // it stays so if nothing else takes it up
      auto& next = tree_.objects[node_[piece]][next_probability];
      next = std::max(next, probability);
    }
  }

  PairSide
  sideOf(std::uint32_t piece) const
  {
    return {pieces_[piece],
            shapes_[piece],
            touching_[piece],
            static_cast<double>(links_[piece].size())};
  }

  /** Join two, note it in the tree, and propose what the union may be joined with. */
  void
  join(const Proposal& best, float level)
  {
    tree_.joins.push_back({best.name_a, best.name_b, level});
    auto &first = tree_.objects[node_[best.a]], &second = tree_.objects[node_[best.b]];
    const bool is_first = links_[best.a].size() >= links_[best.b].size();
    const auto kept = is_first ? best.a : best.b, gone = is_first ? best.b : best.a;
    const float next = tree_.objects[node_[kept]][next_probability];
    first[next_probability] = second[next_probability] = best.probability;
    first[next_size] = second.front() - first.front(); // their log areas
    second[next_size] = -first[next_size];
    criterion_.joined(best.name_a, best.name_b);
    const auto moved = unite(kept, gone);
    name_[kept] = best.name_a;
    node_[kept] = static_cast<std::uint32_t>(tree_.objects.size());
    tree_.objects.push_back(
        description_.describeObject(sideOf(kept), best.probability, level));
    const double size = pieces_[kept].positions.count;
    if (links_[kept].size() > most_contacts &&
        size < (1 + least_growth) * described_size_[kept]) {
      tree_.objects.back()[next_probability] = next;
      for (const auto other : moved)
        propose(kept, other);
      return;
    }
    described_size_[kept] = size;
    for (const auto& link : links_[kept])
      propose(kept, link.first);
  }

  /** One goes up in the other.
   * \return with what it was in contact */
  std::vector<std::uint32_t>
  unite(std::uint32_t kept, std::uint32_t gone)
  {
    const auto between = links_[kept].at(gone).contact;
    touching_[kept] += touching_[gone] - between.first_voxels - between.second_voxels;
    pieces_[kept] += pieces_[gone];
    shapes_[kept] = description_.shapeOf(pieces_[kept]);
    Links moved;
    moved.swap(links_[gone]);
    moved.erase(kept);
    links_[kept].erase(gone);
    std::vector<std::uint32_t> others;
    for (auto& [other, link] : moved) {
      auto& contact = link.contact;
      (contact.first == gone ? contact.first : contact.second) = kept;
      const auto found = links_[kept].find(other);
      if (found != links_[kept].end())
        contact += found->second.contact;
      links_[kept][other].contact = contact;
      links_[other].erase(gone);
      links_[other][kept].contact = contact;
      others.push_back(other);
    }
    return others;
  }

  PairDescription description_;
  JoiningCriterion& criterion_;
  float least_level_;
  std::vector<Piece> pieces_;
  std::vector<PieceShape> shapes_;
  std::vector<double> described_size_; ///< when all contacts were described, voxels
  std::vector<double> touching_; ///< voxels that touch others, some more than once
  std::vector<Links> links_;
  std::vector<std::uint32_t> name_;
  JoinTree tree_;
  std::vector<std::uint32_t> node_; ///< the object that each piece stands for
  std::priority_queue<Proposal> queue_;
  std::uint64_t last_number_ = 0;
};

} // namespace

namespace pcl::indoor {

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

} // namespace pcl::indoor
