/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/join/joining_features.h"
#include "segmentation/objects/join/joining_feature_names.h"
#include "segmentation/objects/join/outline_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace pcl::indoor {
namespace test {

/** Places and normals are multiples of 1/64, so that sums are exact in any order. */
inline Eigen::Vector3d
randomPlace(std::mt19937& rng, unsigned range)
{
  const auto random = [&] { return static_cast<double>(rng() % (64 * range)) / 64; };
  const double x = random(), y = random(), z = random();
  return {x, y, z};
}

inline Piece
randomPiece(std::mt19937& rng)
{
  Piece piece;
  std::vector<Eigen::Vector3f> places;
  const Eigen::Vector3d corner = randomPlace(rng, 3);
  const auto count = 2 + rng() % 8;
  for (unsigned i = 0; i < count; ++i) {
    const Eigen::Vector3d place = corner + randomPlace(rng, 1);
    places.push_back(place.cast<float>());
    piece.positions.add(place);
    piece.normals.add(Eigen::Vector3d::Unit(rng() % 3));
  }
  piece.hull = DirectionHulls().kDopOf(places, 0.015f);
  piece.outline = outlineOf(places);
  return piece;
}

inline PieceContact
randomContact(std::uint32_t first, std::uint32_t second, std::mt19937& rng)
{
  PieceContact contact;
  contact.first = first;
  contact.second = second;
  if (rng() % 3 > 0) {
    contact.first_voxels = 1 + rng() % 4;
    contact.second_voxels = 1 + rng() % 4;
    contact.places.add(randomPlace(rng, 4));
    contact.places.add(randomPlace(rng, 4));
    contact.bends = 1 + rng() % 3;
    contact.bend_sum = contact.bends * static_cast<double>(rng() % 40);
    contact.bend_squares = contact.bend_sum * 30;
    contact.concave_bends = contact.bends - rng() % 2;
  }
  if (rng() % 4 > 0) {
    contact.gap = static_cast<double>(1 + rng() % 16) / 64;
    contact.near_cells = 1 + rng() % 5;
    contact.near_in_line = rng() % 2;
  }
  return contact;
}

inline PieceGraph
randomGraph(std::uint32_t count, unsigned percent, std::mt19937& rng)
{
  PieceGraph graph;
  graph.voxel_size = 1.0 / 32;
  graph.floor = -0.125;
  std::vector<Eigen::Vector3f> voxels;
  for (unsigned v = 0; v < 500; ++v)
    voxels.push_back(randomPlace(rng, 4).cast<float>());
  graph.columns = {voxels, graph.floor, graph.voxel_size};
  for (std::uint32_t p = 0; p < count; ++p)
    graph.pieces.push_back(randomPiece(rng));
  for (std::uint32_t a = 0; a < count; ++a)
    for (std::uint32_t b = a + 1; b < count; ++b)
      if (rng() % 100 < percent)
        graph.contacts.push_back(randomContact(a, b, rng));
  return graph;
}

/** Some smooth function of all features but the numbers of contacts, which change with
 * joins elsewhere, too. */
inline float
probabilityOf(const JoiningFeatures& features)
{
  const auto& names = joiningFeatureNames();
  double sum = 0;
  for (std::size_t i = 0; i < features.size(); ++i) {
    EXPECT_TRUE(std::isfinite(features[i])) << names[i];
    if (std::string(names[i]).substr(0, 9) != "contacts,")
      sum += std::sin(static_cast<double>(i * i) + 1) *
             std::tanh(static_cast<double>(features[i]));
  }
  return static_cast<float>(1 / (1 + std::exp(-sum)));
}

/** Unions by the pieces in them; all that is asked for is found from these. */
class LiteralJoining {
public:
  explicit LiteralJoining(const PieceGraph& graph)
  : graph_(graph)
  , description_(graph)
  {
    for (std::uint32_t p = 0; p < graph.pieces.size(); ++p)
      members_[p] = {p};
  }

  std::vector<PieceJoin>
  joinAll(float least_level)
  {
    std::vector<PieceJoin> joins;
    for (float level = 1;;) {
      std::tuple<float, std::uint32_t, std::uint32_t> best{1, 0, 0};
      for (const auto& a : members_)
        for (const auto& b : members_)
          if (a.first < b.first && near(a.first, b.first)) {
            const auto probability = probabilityOf(featuresOf(a.first, b.first));
            best = std::min(best, std::make_tuple(-probability, a.first, b.first));
          }
      if (-std::get<0>(best) < least_level)
        return joins;
      const auto kept = std::get<1>(best), gone = std::get<2>(best);
      level = std::min(level, -std::get<0>(best));
      joins.push_back({kept, gone, level});
      members_[kept].insert(members_[gone].begin(), members_[gone].end());
      members_.erase(gone);
    }
  }

private:
  bool
  near(std::uint32_t a, std::uint32_t b) const
  {
    const auto& of_a = members_.at(a);
    const auto& of_b = members_.at(b);
    return std::any_of(
        graph_.contacts.begin(), graph_.contacts.end(), [&](const auto& contact) {
          return (of_a.count(contact.first) && of_b.count(contact.second)) ||
                 (of_b.count(contact.first) && of_a.count(contact.second));
        });
  }

  Piece
  unionOf(std::uint32_t name) const
  {
    const auto& members = members_.at(name);
    auto piece = graph_.pieces[*members.begin()];
    for (auto member = std::next(members.begin()); member != members.end(); ++member)
      piece += graph_.pieces[*member];
    return piece;
  }

  /** Voxels of all members that touch pieces outside of the union. */
  double
  touchingOf(std::uint32_t name) const
  {
    const auto& members = members_.at(name);
    double sum = 0;
    for (const auto& contact : graph_.contacts) {
      const bool first = members.count(contact.first) > 0,
                 second = members.count(contact.second) > 0;
      sum += first && !second ? contact.first_voxels : 0;
      sum += second && !first ? contact.second_voxels : 0;
    }
    return sum;
  }

  /** The smaller is the first. */
  JoiningFeatures
  featuresOf(std::uint32_t a, std::uint32_t b) const
  {
    auto piece_a = unionOf(a), piece_b = unionOf(b);
    if (std::make_pair(piece_a.positions.count, a) >
        std::make_pair(piece_b.positions.count, b)) {
      std::swap(a, b);
      std::swap(piece_a, piece_b);
    }
    PieceContact sum;
    sum.first = a;
    sum.second = b;
    for (auto contact : graph_.contacts) {
      if (members_.at(a).count(contact.second) && members_.at(b).count(contact.first)) {
        std::swap(contact.first, contact.second);
        std::swap(contact.first_voxels, contact.second_voxels);
      }
      if (!members_.at(a).count(contact.first) || !members_.at(b).count(contact.second))
        continue;
      contact.first = a;
      contact.second = b;
      sum += contact;
    }
    const auto shape_a = description_.shapeOf(piece_a),
               shape_b = description_.shapeOf(piece_b);
    return description_.describe({piece_a, shape_a, touchingOf(a), 0},
                                 {piece_b, shape_b, touchingOf(b), 0},
                                 sum);
  }

  const PieceGraph& graph_;
  PairDescription description_;
  std::map<std::uint32_t, std::set<std::uint32_t>> members_;
};

} // namespace test
} // namespace pcl::indoor
