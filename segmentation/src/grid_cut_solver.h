/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "grid_bricks.h"

#include <pcl/segmentation/voxel_grid.h>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief Maximum flow on a 6-connected grid, in phases in which all excess moves at once.
 *
 * A voxel that would rather be inside begins with excess, one that would rather be
 * outside with a deficit. Each phase takes the side with fewer voxels as goals, measures
 * the distance of all others to the nearest goal, 64 voxels at a time, and lets the other
 * side flow downhill, farthest first: what meets goes on together. A measurement ends
 * when it has found more than the goals can take.
 *
 * All edges have the same capacity to and fro, thus one number per edge says how much
 * fits through it in both directions.
 */
class GridCutSolver {
public:
  GridCutSolver(const GridShape& shape,
                const std::vector<std::int16_t>& gain,
                int smoothness);

  /** \brief Find the maximum flow. \return its value */
  std::int64_t
  run();

  /** \brief After run(), the voxels that can be reached from excess: the fewest that
   * can be inside.
   */
  std::vector<std::uint8_t>
  inside() const;

private:
  using Index = GridBricks::Index;
  using Bits = GridBricks::Bits;
  static constexpr Index none = ~Index{0};
  static constexpr std::int32_t far = std::numeric_limits<std::int32_t>::max();

  /** \brief What flows: excess along the flow, or deficits against it. */
  enum Side : std::uint8_t { EXCESS, DEFICIT };

  /** \brief One bit per voxel. */
  struct Brick {
    Bits side[2] = {};    // where excess and deficits are that may still meet
    Bits open[2][6] = {}; // more of a side can come from the neighbour in direction d
    Bits reached = 0;      // by the measurement
    Bits reaching = 0;     // by the level at work
    Bits known = 0;        // the level is not far
  };

  /** \brief Some voxels of a brick. */
  struct Part {
    Index brick;
    Bits voxels;
  };

  void
  setUp(const std::vector<std::int16_t>& gain);
  void
  link();
  Side
  chooseFlowing() const;
  void
  measure(int radius);
  std::int64_t
  begin();
  void
  spread(const Part& part);
  void
  reach(Index b, Bits voxels);
  std::int64_t
  settle();
  void
  forgetUnreached();
  void
  flowDownhill();
  void
  activate(Index i);
  void
  discharge(Index i);
  void
  push(Index i, Index j, int d);
  Side
  goals() const
  {
    return flowing_ == EXCESS ? DEFICIT : EXCESS;
  }
  void
  findInside();

  GridShape shape_;
  GridBricks grid_;
  int capacity_;
  std::vector<Brick> bricks_;
  std::vector<std::int32_t> excess_;              // deficits are negative
  std::vector<std::array<std::int16_t, 3>> flow_; // to the neighbours at +x, +y, +z

  std::vector<std::int32_t> level_; // no more than the distance to the nearest goal
  std::vector<Index> next_;
  std::vector<Index> first_; // per level, list of voxels that have something to push
  int highest_ = -1;
  std::vector<Index> stuck_;

  Side flowing_ = EXCESS;       // in this phase; the other side is the goal
  std::vector<Part> front_;     // the highest level
  std::vector<Index> reaching_; // bricks of the next level
  std::size_t reaching_count_ = 0;
  std::size_t reached_ = 0; // voxels
  int limit_ = 0;           // the highest level
  bool complete_ = false;   // all was measured
};

} // namespace indoor
} // namespace pcl
