/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/join/object_joining.h"

#include <cstddef>

namespace pcl::indoor {

/** What follows from a piece alone. */
struct PieceShape {
  double volume = 0, box_volume = 0; ///< of its hull, m^3
  double outline_area = 0;           ///< seen from above, m^2
  double floor_area = 0;             ///< of it, where the floor was seen, m^2
  Eigen::Vector3d mean, deviations;  ///< of its places, ascending, metres
  Eigen::Vector3d thin;              ///< direction in which it is thinnest
  Eigen::Vector3d normal_shares;     ///< of three orthogonal directions, ascending
  double low = 0, high = 0;          ///< over the floor, metres
};

/** One of two pieces. */
struct PairSide {
  const Piece& piece;
  const PieceShape& shape;
  double touching = 0; ///< voxels that touch other pieces; one that touches two counts
                       ///< twice
  double contacts = 0; ///< number of other pieces that are near
};

/** The outlines of two pieces. */
struct PairOutlines {
  KDop16 both;
  double both_area, common_area; ///< m^2

  PairOutlines(const KDop16& a, const KDop16& b);
};

/** Features of an object that tell what becomes of it: the probability of the next
 * join, and the log area of what it joins with, over its own. */
constexpr std::size_t next_probability = 22, next_size = 23;

/** Tells how two pieces lie to each other. */
class PairDescription {
public:
  /** \param[in] graph must outlive the description */
  explicit PairDescription(const PieceGraph& graph);

  PieceShape
  shapeOf(const Piece& piece) const;

  /** \param[in] a the smaller, the first of the contact */
  JoiningFeatures
  describe(const PairSide& a, const PairSide& b, const PieceContact& contact) const;

  /** All that an object is by itself: next_probability and next_size follow. */
  ObjectFeatures
  describeObject(const PairSide& object, float probability, float level) const;

private:
  class FeatureList;

  void
  putPiece(const PairSide& side, FeatureList& list) const;

  void
  putContact(const PairSide& a,
             const PairSide& b,
             const PieceContact& contact,
             FeatureList& list) const;

  static void
  putBend(const PieceContact& contact, FeatureList& list);

  void
  putPlanes(const PairSide& a, const PairSide& b, FeatureList& list) const;

  void
  putHulls(const PairSide& a,
           const PairSide& b,
           const PairOutlines& outlines,
           FeatureList& list) const;

  void
  putHeights(const PairSide& a, const PairSide& b, FeatureList& list) const;

  void
  putVotes(const PairSide& a, const PairSide& b, FeatureList& list) const;

  void
  putVotes(const PairSide& object, FeatureList& list) const;

  void
  putOutlines(const PairSide& a,
              const PairSide& b,
              const PairOutlines& outlines,
              FeatureList& list) const;

  double voxel_size_, floor_;
  const RoomColumns& columns_;
  DirectionHulls hulls_;
};

} // namespace pcl::indoor
