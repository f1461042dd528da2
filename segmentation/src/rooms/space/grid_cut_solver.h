/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/space/grid_bricks.h"
#include "rooms/space/grid_cut.h"

#include <pcl/indoor/voxel_map.h>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace pcl::indoor {

/** \brief The gain of each voxel, in either form. Only a view. */
class VoxelGains {
public:
  explicit VoxelGains(const std::vector<std::int16_t>& values)
  : values_(values.data())
  {}

  explicit VoxelGains(const CodedGains& coded)
  : codes_(coded.codes.data())
  , gain_of_(coded.gain_of.data())
  {}

  int
  operator[](std::size_t voxel) const
  {
    return values_ != nullptr ? values_[voxel] : gain_of_[codes_[voxel]];
  }

private:
  const std::int16_t* values_ = nullptr;
  const std::uint8_t* codes_ = nullptr;
  const std::int16_t* gain_of_ = nullptr;
};

/** \brief Numbers as wide as the gains of buildings need. */
struct NarrowNumbers {
  using Flow = std::int8_t;
  using Excess = std::int16_t;

  /** \brief Whether they hold all that can come to be: what flows is no more than the
   * smoothness, and what a voxel has no more than its gain and six flows. */
  static constexpr bool
  hold(int greatest_gain, int smoothness)
  {
    return smoothness <= std::numeric_limits<Flow>::max() &&
           greatest_gain + 6 * smoothness <= std::numeric_limits<Excess>::max();
  }
};

/** \brief Numbers for all gains. */
struct WideNumbers {
  using Flow = std::int16_t;
  using Excess = std::int32_t;
};

/** \brief Maximum flow on a 6-connected grid by pushing along shortest paths (after
 * Goldberg and Tarjan 1988), in phases in which everything moves at once.
 *
 * A voxel that would rather be inside begins with excess, one that would rather be
 * outside with a deficit; where they meet, both vanish. In each phase one side flows
 * and the other one is its goal: the distance of all voxels to the nearest goal is
 * measured, 64 voxels at a time, until more was found than the goals can take. Then
 * what was found flows downhill, the farthest first, so that what meets goes on
 * together. What is stuck is lifted and tries again while that is cheaper than to
 * measure again. Mostly the deficits flow; now and then the excess does, or many small
 * goals along a corridor would be served one by one.
 *
 * All edges have the same capacity to and fro, thus one number per edge tells how much
 * more it can take in both directions.
 *
 * Most bricks lie in the middle of rooms or far outside, and nothing ever flows there:
 * numbers per voxel are kept for the others only.
 * \tparam Width NarrowNumbers or WideNumbers
 */
template <typename Width>
class GridCutSolver {
public:
  /** \param[in] gain what it views must outlive the solver */
  GridCutSolver(const GridShape& shape, const VoxelGains& gain, int smoothness);

  /** \brief Find the maximum flow. \return its value */
  std::int64_t
  run();

  /** \brief After run(), what can be reached from excess that is left: the fewest
   * voxels that can be inside.
   */
  std::vector<std::uint8_t>
  inside() const;

private:
  using Index = GridBricks::Index;
  using Bits = GridBricks::Bits;
  static constexpr std::int32_t far = std::numeric_limits<std::int32_t>::max();

  enum Side : std::uint8_t { EXCESS, DEFICIT };

  /** \brief One bit per voxel. */
  struct Brick {
    Bits side[2] = {};    // has some of a side that may still meet the other one
    Bits open[2][6] = {}; // more of a side can come from the neighbour in direction d
    Bits reached = 0;     // by the measurement
    Bits reaching = 0;    // by the level at work
    Bits known = 0;       // the level is not far
    Bits ground = 0;      // goals: the level is 0
  };

  using Flow = typename Width::Flow;
  using Excess = std::array<typename Width::Excess, 64>; // per voxel of a brick

  /** \brief What is kept of a brick in which something has flowed. */
  struct Block {
    Excess excess;                // deficits are negative
    std::array<Flow, 3> flow[64]; // to the neighbours at +x, +y, +z
    std::int32_t level[64];       // no more than the distance to the nearest goal
  };

  /** \brief Some voxels of a brick. */
  struct Part {
    Index brick;
    Bits voxels;
  };

  void
  setUp();
  void
  link();
  Block&
  begun(Index brick);
  Block&
  addBlock(Index brick);
  Excess
  gainsOf(Index brick) const;
  Excess
  excessOf(Index brick) const
  {
    return blocks_[brick] != nullptr ? blocks_[brick]->excess : gainsOf(brick);
  }
  std::int64_t
  amountOf(Index brick, Bits voxels) const;
  std::int32_t
  levelOf(Index i) const;
  Side
  goals() const
  {
    return flowing_ == EXCESS ? DEFICIT : EXCESS;
  }

  void
  measure(std::int64_t radius);
  void
  begin();
  void
  climb();
  void
  spread(const Part& part);
  void
  reach(Index b, Bits voxels);
  std::int64_t
  level();
  void
  forgetUnreached();

  void
  activate(Index i);
  void
  flowDownhill();
  void
  prefetch(Index i) const;
  void
  discharge(Index i);
  void
  push(Index i, Index j, int d);
  std::int64_t
  findInside();

  GridShape shape_;
  GridBricks grid_;
  VoxelGains gain_;
  int capacity_;
  std::vector<Brick> bricks_;
  std::vector<Block*> blocks_; // per brick, null where nothing has flowed
  std::vector<std::unique_ptr<Block[]>> chunks_; // that they lie in
  std::size_t chunk_size_, free_ = 0;            // blocks, those left of the last chunk

  std::int64_t amount_[2] = {}; // how much of a side may still meet the other one
  Side flowing_ = EXCESS;       // in this phase; the other side is the goal
  std::vector<Part> front_;     // the highest level
  std::vector<Index> reaching_; // bricks of the next one
  std::size_t reaching_count_ = 0;
  std::size_t reached_ = 0; // voxels
  std::int32_t limit_ = 0;  // the highest level
  bool complete_ = false;   // all that can reach a goal was measured

  std::vector<std::vector<Index>> waiting_; // per level, voxels with something to push
  std::int32_t highest_ = -1;
  std::vector<Index> stuck_;
};

} // namespace pcl::indoor
