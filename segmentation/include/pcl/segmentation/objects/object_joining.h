/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/objects/boosted_trees.h>
#include <pcl/segmentation/objects/piece_graph.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief What is known of two pieces that may be one thing, see joiningFeatureNames().
 */
using JoiningFeatures = std::array<float, 74>;

/** \brief Get what each of the features is. */
const std::array<const char*, std::tuple_size<JoiningFeatures>::value>&
joiningFeatureNames();

/** \brief Two pieces became one. */
struct PieceJoin {
  /** numbers of the two pieces: the union keeps the first, the second is gone */
  std::uint32_t kept = 0, gone = 0;
  float level = 0; ///< least probability of this and all joins before it
};

/** \brief What pieces are joined to. */
enum class JoiningScale {
  Parts, ///< parts of chairs and sofas, as a seat, a back and an arm; else whole things
  Objects, ///< whole things
  View     ///< small things in a camera's view, as on a table
};

/** \brief Tells how probable it is that two pieces are one thing. */
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
class LearnedCriterion : public JoiningCriterion {
public:
  /** \brief Use the bundled trees. */
  explicit LearnedCriterion(JoiningScale scale);

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

/** \brief Join pieces, the most probable pair first. After each join the features of
 * the union are found anew. The cost is n log n for n contacts, about 0.03 ms each time
 * that a pair is judged.
 * \param[in] least_level joins that are less probable are not made
 * \return the joins in their order, by descending level: with a higher least_level the
 * result would be the first of them
 */
std::vector<PieceJoin>
joinPieces(const PieceGraph& graph,
           JoiningCriterion& criterion,
           float least_level = 0.3f);

/** \brief Get the segment of each piece when all joins of at least a level are made:
 * the number of one of its pieces. */
std::vector<std::uint32_t>
segmentsAtLevel(std::size_t piece_count,
                const std::vector<PieceJoin>& joins,
                float level);

} // namespace indoor
} // namespace pcl
