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
    if (parts_.empty())
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

/** \brief Find the voxels from which the flowing side can come to a goal, in the order
 * of their distance, up to a radius; parts_ is empty if nothing can.
 */
void
GridCutSolver::measure(int radius)
{
  std::int64_t missing = begin();
  std::int64_t found = 0;
  std::size_t first = 0;
  int level = 0;
  for (; first < parts_.size() && level < radius && found < missing; ++level) {
    const std::size_t end = parts_.size();
    for (; first < end; ++first)
      spread(parts_[first]);
    found += settle();
  }
  if (first == parts_.size())
    forgetUnreached();
}

/** \brief Begin at the goals. \return how much they can take */
std::int64_t
GridCutSolver::begin()
{
  const Side goals = flowing_ == EXCESS ? DEFICIT : EXCESS;
  std::int64_t missing = 0;
  parts_.clear();
  for (Index b = 0; b < bricks_.size(); ++b) {
    Brick& brick = bricks_[b];
    std::fill_n(brick.downhill, 6, Bits{0});
    brick.reached = brick.side[goals];
    if (brick.reached == 0)
      continue;
    parts_.push_back({b, brick.reached});
    forEachBit(brick.reached, [&](Index v) {
      missing += std::abs(excess_[Index{64} * b + v]);
    });
  }
  return missing;
}

/** \brief Reach the voxels from which a part can be come to. No branches: nothing could
 * predict them.
 */
void
GridCutSolver::spread(const Part& part)
{
  const Bits* open = bricks_[part.brick].open[flowing_];
  for (int d = 0; d < 6; ++d) {
    const Bits voxels = part.voxels & open[d];
    reach(part.brick, GridBricks::within(voxels, d), opposite(d));
    const Bits across = GridBricks::across(voxels, d);
    reach(across != 0 ? grid_.brick(part.brick, d) : part.brick, across, opposite(d));
  }
}

/** \brief Reach voxels of a brick whose neighbours in a direction have been reached. */
void
GridCutSolver::reach(Index b, Bits voxels, int direction)
{
  Brick& brick = bricks_[b];
  voxels &= ~brick.reached;
  reaching_[reaching_count_] = b;
  reaching_count_ += brick.reaching == 0 & voxels != 0;
  brick.reaching |= voxels;
  brick.downhill[direction] |= voxels;
}

/** \brief What is being reached makes up the next level. \return how much is there */
std::int64_t
GridCutSolver::settle()
{
  std::int64_t found = 0;
  for (std::size_t r = 0; r < reaching_count_; ++r) {
    const Index b = reaching_[r];
    Brick& brick = bricks_[b];
    parts_.push_back({b, brick.reaching});
    brick.reached |= brick.reaching;
    forEachBit(brick.reaching & brick.side[flowing_], [&](Index v) {
      found += std::abs(excess_[Index{64} * b + v]);
    });
    brick.reaching = 0;
  }
  reaching_count_ = 0;
  return found;
}

/** \brief What cannot reach a goal now never will. */
void
GridCutSolver::forgetUnreached()
{
  bool any = false;
  const Side goals = flowing_ == EXCESS ? DEFICIT : EXCESS;
  for (Brick& brick : bricks_) {
    brick.side[flowing_] &= brick.reached;
    any |= brick.side[flowing_] != 0;
  }
  (void)goals;
  if (!any)
    parts_.clear();
}

/** \brief Let all that was found flow, farthest first. */
void
GridCutSolver::flowDownhill()
{
  for (; !parts_.empty(); parts_.pop_back()) {
    const auto [b, voxels] = parts_.back();
    forEachBit(voxels & bricks_[b].side[flowing_],
               [b = b, this](Index v) { discharge(Index{64} * b + v); });
  }
}

/** \brief Push what a voxel has to its lower neighbours, as far as it fits. */
void
GridCutSolver::discharge(Index i)
{
  for (int d = 0; d < 6; ++d)
    if (bricks_[i / 64].downhill[d] >> i % 64 & 1) {
      push(i, d);
      if (excess_[i] == 0)
        return;
    }
}

void
GridCutSolver::push(Index i, int d)
{
  const Index j = grid_.neighbour(i, d);
  const int direction = flowing_ == EXCESS ? 1 : -1; // of flow
  std::int16_t& flow = flow_[d % 2 == 0 ? i : j][d / 2];
  const int room = capacity_ - sign(d) * direction * flow;
  const int amount = std::min(direction * excess_[i], room);
  flow = static_cast<std::int16_t>(flow + sign(d) * direction * amount);
  Brick& from = bricks_[i / 64];
  Brick& to = bricks_[j / 64];
  const Bits v = Bits{1} << i % 64;
  const Bits w = Bits{1} << j % 64;
  const Side goals = flowing_ == EXCESS ? DEFICIT : EXCESS;
  from.open[flowing_][d] |= v;
  to.open[goals][opposite(d)] |= w;
  if (amount == room) {
    from.open[goals][d] &= ~v;
    to.open[flowing_][opposite(d)] &= ~w;
  }
  excess_[i] -= direction * amount;
  if (excess_[i] == 0)
    from.side[flowing_] &= ~v;
  excess_[j] += direction * amount;
  if (direction * excess_[j] >= 0)
    to.side[goals] &= ~w;
  if (direction * excess_[j] > 0)
    to.side[flowing_] |= w;
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
  for (std::size_t first = 0; first < parts_.size();) {
    const std::size_t end = parts_.size();
    for (; first < end; ++first)
      spread(parts_[first]);
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
