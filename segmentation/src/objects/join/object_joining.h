/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/join/boosted_trees.h"
#include "objects/join/piece_graph.h"

#include <pcl/indoor/exports.h>
#include <pcl/segmentation/object_segmentation.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief What is known of two pieces that may be one object, see
 * PairDescription::describe(). */
using JoiningFeatures = std::array<float, 86>;

/** \brief What is known of a piece, or of a union of pieces, that may be a whole
 * object, see PairDescription::describeObject(). */
using ObjectFeatures = std::array<float, 30>;

/** \brief The joins of pieces, a tree whose leaves are pieces. */
struct JoinTree {
  std::vector<PieceJoin> joins; ///< in their order, by descending level
  /** of the pieces, then of the union of each join; 0 of pieces without voxels */
  std::vector<ObjectFeatures> objects;
};

/** \brief Tells how probable it is that two pieces are one object. */
class JoiningCriterion {
public:
  virtual ~JoiningCriterion() = default;

  /** \brief Judge a pair.
   * \param[in] features of all pairs
   * \param[in] a, b numbers of the pieces
   * \return probability, 0 to 1 */
  virtual float
  probability(const JoiningFeatures& features, std::uint32_t a, std::uint32_t b) = 0;

  /** \brief Called when two pieces become one, which keeps the number of the first. */
  virtual void
  joined(std::uint32_t /*kept*/, std::uint32_t /*gone*/)
  {}
};

/** \brief The criterion that was learned from simulated scans (the thesis names a
 * learned criterion as the way on, Sec. 4.3.5). */
class PCL_INDOOR_EXPORTS LearnedCriterion : public JoiningCriterion {
public:
  /** \brief Use the bundled trees.
   * \param[in] has_votes as PieceGraph has it; there are such trees for
   * JoiningScale::Objects only */
  explicit LearnedCriterion(JoiningScale scale, bool has_votes = false);

  /** \brief Use others.
   * \throws pcl::BadArgumentException if they are not for JoiningFeatures */
  explicit LearnedCriterion(BoostedTrees trees);

  float
  probability(const JoiningFeatures& features,
              std::uint32_t a,
              std::uint32_t b) override;

private:
  BoostedTrees trees_;
};

/** \brief Join pieces, the most probable pair first. After each join the union
 * is judged anew with all that it is in contact with, about 0.03 ms each. A union with
 * more than 512 contacts is judged with its new ones only, until it has grown by an
 * eighth: else n pieces on one that is not known for a floor would take n^2.
 * \param[in] least_level joins that are less probable are not made: a higher one only
 * makes the list end earlier
 */
PCL_INDOOR_EXPORTS JoinTree
joinPieces(const PieceGraph& graph,
           JoiningCriterion& criterion,
           float least_level = 0.3f);

/** \brief Get the segment of each piece when all joins of at least a level are made:
 * the number of one of its pieces. */
std::vector<std::uint32_t>
segmentsAtLevel(std::size_t piece_count,
                const std::vector<PieceJoin>& joins,
                float level);

/** \brief Get the level that suits what pieces are joined to: 0.4 for objects, 0.7 for
 * parts, 0.9 for views, where a wrong join loses the smaller of two objects. */
float
levelOf(JoiningScale scale);

/** \brief Get how well each piece and each union is expected to fit a true object, as
 * learned from simulated scans.
 * \param[in] scale not JoiningScale::View, for which nothing was learned
 * \param[in] has_votes as for LearnedCriterion
 * \return intersection over union, 0 where that is at most 0.5; one for each of
 * JoinTree::objects
 * \throws pcl::BadArgumentException for JoiningScale::View */
std::vector<float>
expectedFits(const JoinTree& tree, JoiningScale scale, bool has_votes = false);

/** \brief Cut a tree of joins so that the sum of what its segments are worth is
 * greatest. Where two unions stay apart though their join has at least the level, that
 * costs 0.15; it earns as much if the join has less. The cost is linear in the joins.
 * \param[in] joins in their order
 * \param[in] worth of the pieces, then of the union of each join
 * \param[in] level from which joins are to be made when in doubt
 * \return the segment of each piece: the number of one of its pieces */
PCL_INDOOR_EXPORTS std::vector<std::uint32_t>
bestCut(const std::vector<PieceJoin>& joins,
        const std::vector<float>& worth,
        float level);

} // namespace pcl::indoor
