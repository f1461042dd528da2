/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/grid_cut_solver.h"

#include "rooms/space/grid_cut.h"

#include <algorithm>

namespace pcl::indoor {

namespace {

/** \brief The first measurements end early: most of what flows is soon there. */
constexpr int first_radius = 4;
/** \brief What it costs to discharge a voxel, in voxels measured. */
constexpr std::size_t discharge_cost = 8;
/** \brief Blocks that are asked for at once: 37 MB, so much that the system takes them
 * back, and of which it gives only what is used. */
constexpr std::size_t most_at_once = 1 << 16;

int
sign(int direction)
{
  return direction % 2 == 0 ? 1 : -1;
}

} // namespace

template <typename Width>
GridCutSolver<Width>::GridCutSolver(const GridShape& shape,
                                    const VoxelGains& gain,
                                    int smoothness)
: shape_(shape)
, grid_(shape)
, gain_(gain)
, capacity_(smoothness)
, bricks_(grid_.size())
, blocks_(grid_.size(), nullptr)
, chunk_size_(std::min(most_at_once, grid_.size()))
, reaching_(grid_.size() + 1)
{
  setUp();
}

template <typename Width>
void
GridCutSolver<Width>::setUp()
{
  std::size_t v = 0;
  for (int x = 0; x < shape_.nx; ++x)
    for (int y = 0; y < shape_.ny; ++y)
      for (int z = 0; z < shape_.nz; ++z, ++v) {
        const int gain = gain_[v];
        if (gain == GRID_CUT_EXCLUDED)
          continue;
        const std::size_t i = grid_.index(x, y, z);
        Brick& brick = bricks_[i / 64];
        amount_[gain > 0 ? EXCESS : DEFICIT] += std::abs(gain);
        brick.side[EXCESS] |= static_cast<Bits>(gain > 0) << i % 64;
        brick.side[DEFICIT] |= static_cast<Bits>(gain < 0) << i % 64;
        brick.reached |= Bits{1} << i % 64; // takes part; for link() alone
      }
  if (capacity_ > 0)
    link();
}

/** \brief Nothing flows yet: all edges between voxels that take part are open. */
template <typename Width>
void
GridCutSolver<Width>::link()
{
  Index b = 0;
  for (int x = 0; x < shape_.nx; x += 4)
    for (int y = 0; y < shape_.ny; y += 4)
      for (int z = 0; z < shape_.nz; z += 4, ++b) {
        const bool inner[6] = {x + 4 < shape_.nx,
                               x > 0,
                               y + 4 < shape_.ny,
                               y > 0,
                               z + 4 < shape_.nz,
                               z > 0};
        Brick& brick = bricks_[b];
        for (int d = 0; d < 6; ++d) {
          Bits there = GridBricks::within(brick.reached, opposite(d));
          if (inner[d])
            there |=
                GridBricks::across(bricks_[grid_.brick(b, d)].reached, opposite(d));
          brick.open[EXCESS][d] = brick.open[DEFICIT][d] = brick.reached & there;
        }
      }
}

/** \brief The numbers of a brick, which begin as nothing has flowed. */
template <typename Width>
typename GridCutSolver<Width>::Block&
GridCutSolver<Width>::begun(Index brick)
{
  return blocks_[brick] != nullptr ? *blocks_[brick] : addBlock(brick);
}

template <typename Width>
typename GridCutSolver<Width>::Block&
GridCutSolver<Width>::addBlock(Index brick)
{
  if (free_ == 0) {
    chunks_.emplace_back(new Block[chunk_size_]); // not set to 0: it may stay unused
    free_ = chunk_size_;
  }
  Block& block = chunks_.back()[chunk_size_ - free_--];
  block.excess = gainsOf(brick);
  for (Index v = 0; v < 64; ++v) {
    block.flow[v] = {};
    block.level[v] = bricks_[brick].ground >> v & 1 ? 0 : far;
  }
  blocks_[brick] = &block;
  return block;
}

/** \brief 0 where a voxel takes no part. */
template <typename Width>
typename GridCutSolver<Width>::Excess
GridCutSolver<Width>::gainsOf(Index brick) const
{
  Excess gains = {};
  const auto [x, y, z] = grid_.corner(brick);
  for (int u = 0; u < std::min(4, shape_.nx - x); ++u)
    for (int v = 0; v < std::min(4, shape_.ny - y); ++v)
      for (int w = 0; w < std::min(4, shape_.nz - z); ++w) {
        const int gain = gain_[shape_.index(x + u, y + v, z + w)];
        gains[u * 16 + v * 4 + w] =
            static_cast<typename Width::Excess>(gain == GRID_CUT_EXCLUDED ? 0 : gain);
      }
  return gains;
}

/** \brief How much some voxels of a brick have. */
template <typename Width>
std::int64_t
GridCutSolver<Width>::amountOf(Index brick, Bits voxels) const
{
  std::int64_t amount = 0;
  if (voxels != 0) {
    const Excess excess = excessOf(brick);
    forEachBit(voxels, [&](Index v) { amount += std::abs(excess[v]); });
  }
  return amount;
}

template <typename Width>
std::int32_t
GridCutSolver<Width>::levelOf(Index i) const
{
  if (const Block* block = blocks_[i / 64])
    return block->level[i % 64];
  return bricks_[i / 64].ground >> i % 64 & 1 ? 0 : far;
}

/** \brief Phases until nothing can meet. The excess flows in those numbered by a power
 * of two: between two of them distances only grow, which bounds the number of phases.
 */
template <typename Width>
std::int64_t
GridCutSolver<Width>::run()
{
  std::int64_t energy = amount_[EXCESS];
  std::int64_t radius = first_radius;
  for (unsigned phase = 1;;) {
    const bool turn = phase > 1 && (phase & (phase - 1)) == 0;
    flowing_ = turn ? EXCESS : DEFICIT;
    measure(radius);
    if (complete_ && highest_ < 0)
      break;
    flowDownhill();
    if (limit_ == radius)
      radius *= 2;
    else
      ++phase;
  }
  energy -= findInside();
  return energy;
}

/** \brief Give the voxels from which the flowing side can come to a goal their
 * distance, up to a radius and until more was found than the goals can take.
 */
template <typename Width>
void
GridCutSolver<Width>::measure(std::int64_t radius)
{
  begin();
  std::int64_t found = 0;
  while (!front_.empty() && limit_ < radius && found < amount_[goals()]) {
    climb();
    found += level();
  }
  complete_ = front_.empty();
  forgetUnreached();
}

/** \brief The goals are on the ground. */
template <typename Width>
void
GridCutSolver<Width>::begin()
{
  front_.clear();
  waiting_.clear();
  waiting_.emplace_back();
  limit_ = 0;
  highest_ = -1;
  reached_ = 0;
  for (Index b = 0; b < bricks_.size(); ++b) {
    Brick& brick = bricks_[b];
    brick.reached = brick.side[goals()];
    if (brick.reached != 0)
      front_.push_back({b, brick.reached});
    if (Block* block = blocks_[b])
      forEachBit(brick.reached & ~brick.ground, [&](Index v) { block->level[v] = 0; });
    brick.ground = brick.reached;
  }
}

/** \brief Reach the next level. */
template <typename Width>
void
GridCutSolver<Width>::climb()
{
  for (const Part& part : front_)
    spread(part);
  front_.clear();
  for (std::size_t r = 0; r < reaching_count_; ++r) {
    const Index b = reaching_[r];
    Brick& brick = bricks_[b];
    front_.push_back({b, brick.reaching});
    brick.reached |= brick.reaching;
    brick.reaching = 0;
  }
  reaching_count_ = 0;
}

/** \brief Reach the voxels from which a part can be come to. */
template <typename Width>
void
GridCutSolver<Width>::spread(const Part& part)
{
  const Bits* open = bricks_[part.brick].open[flowing_];
  Bits within = 0;
  for (int d = 0; d < 6; ++d) {
    const Bits voxels = part.voxels & open[d];
    within |= GridBricks::within(voxels, d);
    if (const Bits across = GridBricks::across(voxels, d))
      reach(grid_.brick(part.brick, d), across);
  }
  reach(part.brick, within);
}

/** \brief Reach voxels of a brick. */
template <typename Width>
void
GridCutSolver<Width>::reach(Index b, Bits voxels)
{
  Brick& brick = bricks_[b];
  voxels &= ~brick.reached;
  const bool begins = brick.reaching == 0 && voxels != 0;
  brick.reaching |= voxels;
  reaching_[reaching_count_] = b; // without a branch that nothing could predict
  reaching_count_ += begins;
}

/** \brief What was reached last is a level.
 * \return how much of the flowing side is
 * there */
template <typename Width>
std::int64_t
GridCutSolver<Width>::level()
{
  std::int64_t found = 0;
  ++limit_;
  waiting_.emplace_back();
  for (const Part& part : front_) {
    Block& block = begun(part.brick);
    forEachBit(part.voxels, [&](Index v) {
      block.level[v] = limit_;
      ++reached_;
    });
    forEachBit(part.voxels & bricks_[part.brick].side[flowing_], [&](Index v) {
      found += std::abs(block.excess[v]);
      activate(Index{64} * part.brick + v);
    });
  }
  return found;
}

/** \brief What cannot reach a goal, when all was measured, never will. */
template <typename Width>
void
GridCutSolver<Width>::forgetUnreached()
{
  for (Index b = 0; b < bricks_.size(); ++b) {
    Brick& brick = bricks_[b];
    if (Block* block = blocks_[b])
      forEachBit(brick.known & ~brick.reached, [&](Index v) { block->level[v] = far; });
    brick.known = brick.reached;
    if (!complete_)
      continue;
    amount_[flowing_] -= amountOf(b, brick.side[flowing_] & ~brick.reached);
    brick.side[flowing_] &= brick.reached;
  }
}

template <typename Width>
void
GridCutSolver<Width>::activate(Index i)
{
  const std::int32_t level = blocks_[i / 64]->level[i % 64];
  waiting_[level].push_back(i);
  highest_ = std::max(highest_, level);
}

/** \brief Let all that was found flow, farthest first; lift what is stuck, and again,
 * while that is cheaper than to measure again.
 */
template <typename Width>
void
GridCutSolver<Width>::flowDownhill()
{
  std::size_t discharged = 0;
  do {
    stuck_.clear();
    for (; highest_ >= 0; --highest_) {
      auto& voxels = waiting_[highest_]; // what is pushed goes to lower levels
      for (; !voxels.empty(); ++discharged) {
        const Index i = voxels.back();
        voxels.pop_back();
        if (!voxels.empty())
          prefetch(voxels.back());
        discharge(i);
      }
      std::vector<Index>().swap(voxels); // the lower ones grow
    }
    for (const Index i : stuck_)
      activate(i);
  } while (!stuck_.empty() && discharged * discharge_cost < reached_);
}

/** \brief Waiting for memory takes longer than a discharge. */
template <typename Width>
void
GridCutSolver<Width>::prefetch(Index i) const
{
  const Block* block = blocks_[i / 64];
  __builtin_prefetch(&block->level[i % 64]);
  __builtin_prefetch(&block->excess[i % 64]);
  __builtin_prefetch(&block->flow[i % 64]);
  __builtin_prefetch(&bricks_[i / 64]);
}

/** \brief Push what a voxel has to its lower neighbours, as far as it fits; lift it to
 * where the rest can flow on.
 */
template <typename Width>
void
GridCutSolver<Width>::discharge(Index i)
{
  const Brick& brick = bricks_[i / 64];
  Block& block = *blocks_[i / 64];
  const std::int32_t level = block.level[i % 64];
  std::int32_t lowest = far;
  for (int d = 0; d < 6; ++d) {
    if (!(brick.open[goals()][d] >> i % 64 & 1))
      continue;
    const Index j = grid_.neighbour(i, d);
    const std::int32_t other = levelOf(j);
    if (other != level - 1) {
      lowest = std::min(lowest, other);
      continue;
    }
    push(i, j, d);
    if (block.excess[i % 64] == 0)
      return;
  }
  if (lowest >= limit_)
    return;
  block.level[i % 64] = lowest + 1;
  stuck_.push_back(i);
}

/** \brief Push as much as there is and as fits to a neighbour. */
template <typename Width>
void
GridCutSolver<Width>::push(Index i, Index j, int d)
{
  const int towards = flowing_ == EXCESS ? 1 : -1; // deficits go against the flow
  const int along = sign(d) * towards;
  Block& giving = *blocks_[i / 64];
  Block& taking = begun(j / 64);
  Flow& flow = d % 2 == 0 ? giving.flow[i % 64][d / 2] : taking.flow[j % 64][d / 2];
  const int room = capacity_ - along * flow;
  const int amount = std::min(towards * giving.excess[i % 64], room);
  flow = static_cast<Flow>(flow + along * amount);

  Brick& from = bricks_[i / 64];
  Brick& to = bricks_[j / 64];
  const Bits v = Bits{1} << i % 64;
  const Bits w = Bits{1} << j % 64;
  from.open[flowing_][d] |= v; // it can come back
  to.open[goals()][opposite(d)] |= w;
  if (amount == room) {
    from.open[goals()][d] &= ~v;
    to.open[flowing_][opposite(d)] &= ~w;
  }

  auto& given = giving.excess[i % 64];
  given = static_cast<typename Width::Excess>(given - towards * amount);
  if (given == 0)
    from.side[flowing_] &= ~v;
  auto& taken = taking.excess[j % 64];
  const int before = towards * taken;
  taken = static_cast<typename Width::Excess>(taken + towards * amount);
  if (before < 0) {
    const int met = std::min(amount, -before);
    amount_[EXCESS] -= met;
    amount_[DEFICIT] -= met;
    if (met == -before)
      to.side[goals()] &= ~w;
  }
  if (before <= 0 && before + amount > 0) {
    to.side[flowing_] |= w;
    activate(j);
  }
}

/** \brief Reach all that can be reached from excess that is left.
 * \return how much that
 * is
 */
template <typename Width>
std::int64_t
GridCutSolver<Width>::findInside()
{
  std::int64_t left = 0;
  for (Index b = 0; b < bricks_.size(); ++b) {
    Brick& brick = bricks_[b];
    const Excess excess = excessOf(b);
    brick.side[EXCESS] = 0;
    for (Index v = 0; v < 64; ++v) {
      brick.side[EXCESS] |= static_cast<Bits>(excess[v] > 0) << v;
      left += std::max<std::int64_t>(excess[v], 0);
    }
  }
  std::fill(blocks_.begin(), blocks_.end(), nullptr); // nothing flows any more
  chunks_.clear();
  flowing_ = DEFICIT;
  begin();
  while (!front_.empty())
    climb();
  return left;
}

template <typename Width>
std::vector<std::uint8_t>
GridCutSolver<Width>::inside() const
{
  std::vector<std::uint8_t> inside;
  inside.reserve(shape_.size());
  for (int x = 0; x < shape_.nx; ++x)
    for (int y = 0; y < shape_.ny; ++y)
      for (int z = 0; z < shape_.nz; ++z) {
        const std::size_t i = grid_.index(x, y, z);
        inside.push_back(bricks_[i / 64].reached >> i % 64 & 1);
      }
  return inside;
}

template class GridCutSolver<NarrowNumbers>;
template class GridCutSolver<WideNumbers>;

} // namespace pcl::indoor
