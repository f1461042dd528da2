/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "grid_cut_solver.h"

#include <pcl/segmentation/grid_cut.h>

#include <algorithm>

namespace pcl {
namespace indoor {

namespace {

/** \brief The first measurements end early: most flow goes to near places. */
constexpr int first_radius = 4;
/** \brief What a voxel's discharge costs, in voxels measured. */
constexpr std::size_t discharge_cost = 8;

int
sign(int direction)
{
  return direction % 2 == 0 ? 1 : -1;
}

} // namespace

GridCutSolver::GridCutSolver(const GridShape& shape,
                             const std::vector<std::int16_t>& gain,
                             int smoothness)
: shape_(shape)
, grid_(shape)
, capacity_(smoothness)
, bricks_(grid_.size())
, excess_(64 * grid_.size())
, flow_(64 * grid_.size())
, level_(64 * grid_.size(), far)
, next_(64 * grid_.size())
, reaching_(grid_.size() + 1)
{
  setUp(gain);
}

void
GridCutSolver::setUp(const std::vector<std::int16_t>& gain)
{
  std::size_t v = 0;
  for (int x = 0; x < shape_.nx; ++x)
    for (int y = 0; y < shape_.ny; ++y)
      for (int z = 0; z < shape_.nz; ++z, ++v) {
        if (gain[v] == GRID_CUT_EXCLUDED)
          continue;
        const std::size_t i = grid_.index(x, y, z);
        Brick& brick = bricks_[i / 64];
        excess_[i] = gain[v];
        brick.side[EXCESS] |= static_cast<Bits>(gain[v] > 0) << i % 64;
        brick.side[DEFICIT] |= static_cast<Bits>(gain[v] < 0) << i % 64;
        brick.reached |= Bits{1} << i % 64; // takes part; for link() alone
      }
  if (capacity_ > 0)
    link();
}

/** \brief Nothing flows yet: all edges between voxels that take part are open. */
void
GridCutSolver::link()
{
  Index b = 0;
  for (int x = 0; x < shape_.nx; x += 4)
    for (int y = 0; y < shape_.ny; y += 4)
      for (int z = 0; z < shape_.nz; z += 4, ++b) {
        const bool inner[6] = {
            x + 4 < shape_.nx, x > 0, y + 4 < shape_.ny, y > 0, z + 4 < shape_.nz, z > 0};
        Brick& brick = bricks_[b];
        for (int d = 0; d < 6; ++d) {
          Bits there = GridBricks::within(brick.reached, opposite(d));
          if (inner[d])
            there |= GridBricks::across(bricks_[grid_.brick(b, d)].reached, opposite(d));
          brick.open[EXCESS][d] = brick.open[DEFICIT][d] = brick.reached & there;
        }
      }
}

std::int64_t
GridCutSolver::run()
{
  std::int64_t energy = 0;
  for (const std::int32_t excess : excess_)
    energy += std::max(excess, 0);
  for (int radius = first_radius;; radius = std::min(2 * radius, 1 << 29)) {
    flowing_ = chooseFlowing();
    measure(radius);
    if (complete_ && highest_ < 0)
      break;
    flowDownhill();
  }
  for (const std::int32_t excess : excess_)
    energy -= std::max(excess, 0);
  findInside();
  return energy;
}

/** \brief The side with more voxels, so that there are few goals. */
GridCutSolver::Side
GridCutSolver::chooseFlowing() const
{
  std::size_t count[2] = {};
  for (const Brick& brick : bricks_)
    for (const Side side : {EXCESS, DEFICIT})
      count[side] += bitCount(brick.side[side]);
  return count[EXCESS] > count[DEFICIT] ? EXCESS : DEFICIT;
}

/** \brief Give all voxels from which the flowing side can come to a goal their distance,
 * up to a radius.
 */
void
GridCutSolver::measure(int radius)
{
  const std::int64_t missing = begin();
  std::int64_t found = 0;
  for (limit_ = 0; !front_.empty() && limit_ < radius && found < missing; ++limit_) {
    for (const Part& part : front_)
      spread(part);
    found += settle();
  }
  complete_ = front_.empty();
  forgetUnreached();
}

/** \brief Begin at the goals. \return how much they can take */
std::int64_t
GridCutSolver::begin()
{
  std::int64_t missing = 0;
  front_.clear();
  first_.assign(1, none);
  highest_ = -1;
  reached_ = 0;
  for (Index b = 0; b < bricks_.size(); ++b) {
    Brick& brick = bricks_[b];
    brick.reached = brick.side[goals()];
    if (brick.reached == 0)
      continue;
    front_.push_back({b, brick.reached});
    forEachBit(brick.reached, [&](Index v) {
      missing += std::abs(excess_[Index{64} * b + v]);
      level_[Index{64} * b + v] = 0;
    });
  }
  return missing;
}

/** \brief Reach the voxels from which a part can be come to. */
void
GridCutSolver::spread(const Part& part)
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
void
GridCutSolver::reach(Index b, Bits voxels)
{
  Brick& brick = bricks_[b];
  voxels &= ~brick.reached;
  reaching_[reaching_count_] = b;
  reaching_count_ += brick.reaching == 0 & voxels != 0;
  brick.reaching |= voxels;
}

/** \brief What is being reached makes up the next level. \return how much is there */
std::int64_t
GridCutSolver::settle()
{
  std::int64_t found = 0;
  front_.clear();
  first_.push_back(none);
  for (std::size_t r = 0; r < reaching_count_; ++r) {
    const Index b = reaching_[r];
    Brick& brick = bricks_[b];
    front_.push_back({b, brick.reaching});
    brick.reached |= brick.reaching;
    reached_ += bitCount(brick.reaching);
    forEachBit(brick.reaching, [&](Index v) { level_[Index{64} * b + v] = limit_ + 1; });
    forEachBit(brick.reaching & brick.side[flowing_], [&](Index v) {
      found += std::abs(excess_[Index{64} * b + v]);
      activate(Index{64} * b + v);
    });
    brick.reaching = 0;
  }
  reaching_count_ = 0;
  return found;
}

/** \brief What cannot reach a goal, when all was measured, never will. */
void
GridCutSolver::forgetUnreached()
{
  for (Index b = 0; b < bricks_.size(); ++b) {
    Brick& brick = bricks_[b];
    forEachBit(brick.known & ~brick.reached,
               [&](Index v) { level_[Index{64} * b + v] = far; });
    brick.known = brick.reached;
    if (complete_)
      brick.side[flowing_] &= brick.reached;
  }
}

void
GridCutSolver::activate(Index i)
{
  const std::int32_t level = level_[i];
  next_[i] = first_[level];
  first_[level] = i;
  highest_ = std::max(highest_, level);
}

/** \brief Let all that was found flow, farthest first; lift what is stuck, and again,
 * while that is cheaper than to measure again.
 */
void
GridCutSolver::flowDownhill()
{
  std::size_t discharged = 0;
  do {
    stuck_.clear();
    for (; highest_ >= 0; --highest_)
      while (first_[highest_] != none) {
        const Index i = first_[highest_];
        first_[highest_] = next_[i];
        discharge(i);
        ++discharged;
      }
    for (const Index i : stuck_)
      activate(i);
  } while (!stuck_.empty() && discharged * discharge_cost < reached_);
}

/** \brief Push what a voxel has to its lower neighbours, as far as it fits; lift it to
 * where the rest can flow on.
 */
void
GridCutSolver::discharge(Index i)
{
  const Brick& brick = bricks_[i / 64];
  const std::int32_t level = level_[i];
  std::int32_t lowest = far;
  for (int d = 0; d < 6; ++d) {
    if (!(brick.open[goals()][d] >> i % 64 & 1))
      continue;
    const Index j = grid_.neighbour(i, d);
    if (level_[j] != level - 1) {
      lowest = std::min(lowest, level_[j]);
      continue;
    }
    push(i, j, d);
    if (excess_[i] == 0)
      return;
  }
  if (lowest >= limit_)
    return;
  level_[i] = lowest + 1;
  stuck_.push_back(i);
}

void
GridCutSolver::push(Index i, Index j, int d)
{
  const int direction = flowing_ == EXCESS ? 1 : -1; // of flow
  std::int16_t& flow = flow_[d % 2 == 0 ? i : j][d / 2];
  const int room = capacity_ - sign(d) * direction * flow;
  const int amount = std::min(direction * excess_[i], room);
  flow = static_cast<std::int16_t>(flow + sign(d) * direction * amount);
  Brick& from = bricks_[i / 64];
  Brick& to = bricks_[j / 64];
  const Bits v = Bits{1} << i % 64;
  const Bits w = Bits{1} << j % 64;
  from.open[flowing_][d] |= v;
  to.open[goals()][opposite(d)] |= w;
  if (amount == room) {
    from.open[goals()][d] &= ~v;
    to.open[flowing_][opposite(d)] &= ~w;
  }
  excess_[i] -= direction * amount;
  if (excess_[i] == 0)
    from.side[flowing_] &= ~v;
  const bool idle = direction * excess_[j] <= 0;
  excess_[j] += direction * amount;
  if (direction * excess_[j] >= 0)
    to.side[goals()] &= ~w;
  if (direction * excess_[j] > 0 && idle) {
    to.side[flowing_] |= w;
    activate(j);
  }
}

/** \brief Reach all that can be reached from excess. */
void
GridCutSolver::findInside()
{
  for (Index i = 0; i < excess_.size(); ++i)
    if (excess_[i] > 0)
      bricks_[i / 64].side[EXCESS] |= Bits{1} << i % 64;
  flowing_ = DEFICIT;
  for (Brick& brick : bricks_)
    brick.side[DEFICIT] = 0;
  begin();
  while (!front_.empty()) {
    for (const Part& part : front_)
      spread(part);
    settle();
  }
}

std::vector<std::uint8_t>
GridCutSolver::inside() const
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

} // namespace indoor
} // namespace pcl
