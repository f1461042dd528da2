/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/eppf_options.h>
#include <pcl/features/line_occupancy.h>
#include <pcl/features/oriented_point.h>
#include <pcl/features/pair_counting.h>
#include <pcl/features/pair_sampling.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Puts the pairs of an object into bins: all that is the same for all pairs. */
class PairCounter {
public:
  /** \brief Prepare to count.
   * \param[in] points at least two places
   * \param[in] sampler of the points' pairs
   * \param[in] scale metres that f1 spreads over
   * \param[in] options kept by reference
   */
  PairCounter(const std::vector<OrientedPoint>& points,
              PairSampler sampler,
              double scale,
              const EPPFOptions& options);

  /** \brief Count the pairs first_pair to last_pair, at most pair_block_size. */
  void
  count(std::size_t first_pair,
        std::size_t last_pair,
        std::vector<std::uint64_t>& counts) const;

  /** \brief Count pairs, each by the product of its points' weights, and pairs near a
   * border of f1 or of the joint f2 partly in the bin beyond it.
   * \param[in] weights of the points, 0 ... 1
   * \param[in] softness width of a border's surroundings, in bins, above 0 up to 1
   * \param[in,out] counts in units of 2^-16 pairs
   */
  void
  addInterpolated(std::size_t first_pair,
                  std::size_t last_pair,
                  const std::vector<float>& weights,
                  float softness,
                  std::vector<std::uint64_t>& counts) const;

private:
  /** \brief What the inner loop reads of a point: half a cache line. */
  struct Surflet {
    Eigen::Vector3f position;
    Eigen::Vector3f normal;
    LineOccupancy::Cell cell;
  };

  /** \brief The features of a block of pairs, before they are put into bins. */
  struct PairBlock {
    std::array<float, pair_block_size> distance;
    std::array<float, pair_block_size> first_sine;  // of the surface angle -beta_1
    std::array<float, pair_block_size> second_sine; // of the surface angle -beta_2
    std::array<float, pair_block_size> cosine;      // of f3
    std::array<LineOccupancy::Line, pair_block_size> line;
    std::array<std::uint8_t, pair_block_size> occupancy_bin;
    std::array<std::uint32_t, pair_block_size> pair; // counted from the block's first
    std::array<std::uint32_t, pair_block_size> bin;
    std::size_t size = 0;
  };

  void
  setBorders();
  void
  measure(std::size_t first_pair, std::size_t last_pair, PairBlock& block) const;
  void
  walkLines(PairBlock& block) const;
  static void
  turnAroundLine(PairBlock& block);
  void
  combineAngles(PairBlock& block) const;
  static void
  addBorders(const std::array<float, pair_block_size>& values,
             const std::vector<float>& borders,
             std::uint32_t stride,
             PairBlock& block);
  void
  addDistanceBins(PairBlock& block) const;
  void
  addSurfaceBins(PairBlock& block) const;
  void
  addNormalBins(PairBlock& block) const;
  void
  addOccupancyBins(PairBlock& block) const;

  const EPPFOptions& options_;
  PairSampler sampler_;
  LineOccupancy grid_;
  std::vector<Surflet> surflets_;
  std::vector<float> surface_borders_;
  std::vector<float> second_borders_;
  std::vector<float> normal_borders_;
  std::array<std::uint8_t, 64 * 64> occupancy_bins_{};
  float bins_per_metre_ = 0.0f;
};

} // namespace pcl::indoor
