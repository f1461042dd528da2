/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief The gain of voxels that take no part in the cut. */
constexpr std::int16_t GRID_CUT_EXCLUDED = INT16_MIN;
/** \brief The largest absolute value of a gain. */
constexpr int grid_cut_max_gain = INT16_MAX;
/** \brief The largest smoothness. */
constexpr int grid_cut_max_smoothness = 16383;

/** \brief The cheapest labelling of a grid. */
struct GridCut {
  std::vector<std::uint8_t> inside; ///< 1 for voxels inside; 0 outside or excluded
  std::int64_t energy = 0;          ///< of this labelling, see cutGrid()
};

/** \brief A gain per voxel of a grid, where few are different: a byte per voxel, and
 * what it stands for. */
struct CodedGains {
  std::vector<std::uint8_t> codes;         ///< per voxel
  std::array<std::int16_t, 256> gain_of{}; ///< of each code

  /** \brief The gain of a voxel. REQUIRES: voxel < codes.size(). */
  std::int16_t
  operator[](std::size_t voxel) const
  {
    return gain_of[codes[voxel]];
  }
};

/** \brief The exact minimum of a binary Potts energy on a 6-connected voxel grid, by
 * a minimum cut (Sec. 2.1.6.1, Eq. (3.2)).
 *
 * Energy: a voxel pays its gain if it is positive and the voxel is outside, and minus
 * its gain if that is negative and the voxel is inside; each pair of neighbours that
 * are not excluded pays the smoothness if their labels differ. (The smoothness after
 * Eq. (3.2) is misprinted: a Potts term penalises labels that differ.) All costs are
 * integers in a unit of the caller's choice, so that the result is exact. Among several
 * minima the one with the fewest voxels inside is returned: it is unique, thus the
 * result does not depend on the order of the computation.
 *
 * Flow is pushed along shortest paths (after Goldberg and Tarjan, JACM 1988) on a graph
 * left implicit: 2.4 bytes per voxel, each side of the grid rounded up to a multiple of
 * 4, and 9 more for those of the bricks of 4 x 4 x 4 voxels in which something flows,
 * fewer than half in buildings; 14 where a smoothness above 127 or gains above 32,000
 * need wider numbers. Time per voxel grows with how far flow must go.
 * Buildings take 20 to 400 ns, independent random gains 0.5 to 2.5 us.
 *
 * \param[in] shape the grid
 * \param[in] gain per voxel, how much cheaper inside is than outside; or
 * GRID_CUT_EXCLUDED
 * \param[in] smoothness cost of a pair of neighbours with different labels
 * (0 ... grid_cut_max_smoothness)
 * \throws pcl::BadArgumentException if the number of gains does not fit the shape, the
 * smoothness leaves its range, or the grid has more than 2^31 - 2 voxels, or 2^32 with
 * its sides rounded up
 */
GridCut
cutGrid(const GridShape& shape, const std::vector<std::int16_t>& gain, int smoothness);

/** \brief The same with a byte per voxel. */
GridCut
cutGrid(const GridShape& shape, const CodedGains& gain, int smoothness);

} // namespace pcl::indoor
