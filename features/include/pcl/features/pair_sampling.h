/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>
#include <pcl/indoor/exports.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::indoor {

/** \brief How point pairs are chosen. */
enum class PairSampling {
  Uniform,   ///< two different points, all pairs equally likely (the thesis)
  Stratified ///< evenly spread over all pairs, along a space-filling order of the
             ///< points
};

/** \brief Indices of points along a Z curve (Morton order) through their cube; of
 * points in one cell of the curve, by their coordinates. Empty for no points. */
PCL_INDOOR_EXPORTS std::vector<std::uint32_t>
spaceFillingOrder(const std::vector<OrientedPoint>& points);

/** \brief Draws pairs of different points.
 *
 * Pair k depends on the seed and on k alone, so that any thread can draw any pair: this
 * is why there is no generator whose state would have to be passed on.
 */
class PCL_INDOOR_EXPORTS PairSampler {
public:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  /** \brief Prepare to draw.
   * \param[in] points at least two, fewer than 2^32
   * \param[in] sampling how
   * \param[in] seed same seed, same pairs
   */
  PairSampler(const std::vector<OrientedPoint>& points,
              PairSampling sampling,
              std::uint32_t seed);

  /** \brief Prepare to draw stratified pairs of points that lie along a space-filling
   * order already.
   * \param[in] point_count at least two
   * \param[in] seed same seed, same pairs
   */
  PairSampler(std::size_t point_count, std::uint32_t seed);

  /** \brief Indices of two different points. */
  Pair
  pair(std::uint64_t k) const
  {
    if (!is_stratified_) {
      const std::uint64_t draw = hash(seed_ + k * 0x9E3779B97F4A7C15u);
      return differing(static_cast<std::uint32_t>(draw >> 32),
                       static_cast<std::uint32_t>(draw));
    }
    // The additive sequence of the plastic number fills the unit square evenly.
    const auto ranks =
        differing(static_cast<std::uint32_t>((seed_ >> 32) + k * 3242174889u),
                  static_cast<std::uint32_t>(seed_ + k * 2447445414u));
    return order_.empty() ? ranks : Pair{order_[ranks.first], order_[ranks.second]};
  }

private:
  /** \brief The finaliser of splitmix64: every bit of the result depends on every bit.
   */
  static std::uint64_t
  hash(std::uint64_t value)
  {
    value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9u;
    value = (value ^ (value >> 27)) * 0x94D049BB133111EBu;
    return value ^ (value >> 31);
  }

  /** \brief Two numbers of 32 bits as two different indices. */
  Pair
  differing(std::uint32_t one, std::uint32_t two) const
  {
    const auto first = static_cast<std::uint32_t>((one * point_count_) >> 32);
    const auto second = static_cast<std::uint32_t>((two * (point_count_ - 1)) >> 32);
    return {first, second + (second >= first ? 1u : 0u)};
  }

  std::uint64_t seed_;
  std::uint64_t point_count_;
  bool is_stratified_;
  std::vector<std::uint32_t>
      order_; // of the points along a Z curve; empty: as they lie
};

} // namespace pcl::indoor
