/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/indoor/point_cells.h>

#include "internal/point_bounds.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

constexpr int axis_bits = 21;
constexpr double largest_cell = (1 << axis_bits) - 3; // one cell of margin at both ends
constexpr std::uint32_t no_cell = 0xffffffffu;

/** Open addressing from key to a number given in order of arrival. */
class KeyNumbers {
public:
  std::uint32_t
  number(std::uint64_t key)
  {
    if (2 * keys_.size() >= slots_.size())
      grow();
    std::size_t slot = slotOf(key);
    while (slots_[slot] != no_cell && keys_[slots_[slot]] != key)
      slot = (slot + 1) & (slots_.size() - 1);
    if (slots_[slot] == no_cell) {
      slots_[slot] = static_cast<std::uint32_t>(keys_.size());
      keys_.push_back(key);
    }
    return slots_[slot];
  }

  const std::vector<std::uint64_t>&
  keys() const
  {
    return keys_;
  }

private:
  /** The highest bits of the product: all bits of the key have a say in them. */
  std::size_t
  slotOf(std::uint64_t key) const
  {
    return (key * 0x9e3779b97f4a7c15ull) >> (64 - slot_bits_);
  }

  void
  grow()
  {
    slot_bits_ += 2;
    slots_.assign(std::size_t(1) << slot_bits_, no_cell);
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      std::size_t slot = slotOf(keys_[i]);
      while (slots_[slot] != no_cell)
        slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = static_cast<std::uint32_t>(i);
    }
  }

  std::vector<std::uint64_t> keys_;
  int slot_bits_ = 12;
  std::vector<std::uint32_t> slots_ = std::vector<std::uint32_t>(1 << 12, no_cell);
};

std::uint64_t
packed(const Eigen::Vector3d& cell)
{
  // x in the highest bits: the three cells of a vertical triple have consecutive keys.
  const auto part = [&](int axis) {
    return static_cast<std::uint64_t>(cell[axis]) + 1;
  };
  return (part(0) << (2 * axis_bits)) | (part(1) << axis_bits) | part(2);
}

/** Number the points' cells in ascending order of keys. */
void
sortCells(pcl::indoor::PointCells& cells, const std::vector<std::uint64_t>& keys)
{
  std::vector<std::uint32_t> order(keys.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(
      order.begin(), order.end(), [&](auto a, auto b) { return keys[a] < keys[b]; });
  std::vector<std::uint32_t> rank(keys.size());
  cells.keys.resize(keys.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    rank[order[i]] = static_cast<std::uint32_t>(i);
    cells.keys[i] = keys[order[i]];
  }
  for (auto& cell : cells.cell_of_point)
    cell = rank[cell];
}

} // namespace

namespace pcl::indoor {

void
listPoints(PointCells& cells)
{
  cells.offsets.assign(cells.size() + 1, 0);
  for (const auto cell : cells.cell_of_point)
    ++cells.offsets[cell + 1];
  std::partial_sum(cells.offsets.begin(), cells.offsets.end(), cells.offsets.begin());
  cells.points.resize(cells.cell_of_point.size());
  auto next = cells.offsets;
  for (std::size_t i = 0; i < cells.cell_of_point.size(); ++i)
    cells.points[next[cells.cell_of_point[i]]++] = static_cast<std::uint32_t>(i);
}

PointCells
groupByCell(const std::vector<Eigen::Vector3f>& points, double cell_size)
{
  if (!(cell_size > 0) || !std::isfinite(cell_size))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The cell size must be positive, not " << cell_size << " m.");
  PointCells cells;
  if (points.empty())
    return cells;
  const auto bounds = boundsOf(points);
  const double extent = bounds.sizes().maxCoeff();
  if (!(extent / cell_size < largest_cell))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Cells of " << cell_size << " m are too small for an extent of "
                                    << extent << " m.");
  const Eigen::Vector3d origin = bounds.min().cast<double>();
  KeyNumbers numbers;
  cells.cell_of_point.reserve(points.size());
  for (const auto& point : points) {
    const Eigen::Vector3d offset = point.cast<double>() - origin;
    cells.cell_of_point.push_back(
        numbers.number(packed((offset / cell_size).array().floor().matrix())));
  }
  sortCells(cells, numbers.keys());
  listPoints(cells);
  return cells;
}

Adjacency
cellAdjacency(const std::vector<std::uint64_t>& keys)
{
  // Keys are ascending, so for each of the nine vertical triples around a cell the
  // first candidate only moves forward: nine cursors, no search.
  constexpr std::uint64_t row = 1ull << axis_bits, slab = 1ull << (2 * axis_bits);
  const std::uint64_t back = slab + row + 1; // from a cell to its lowest neighbour
  std::vector<std::size_t> cursor(9, 0);
  Adjacency adjacency;
  adjacency.offsets.reserve(keys.size() + 1);
  adjacency.offsets.push_back(0);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    for (std::uint64_t column = 0; column < 9; ++column) {
      const auto lowest = keys[i] - back + (column / 3) * slab + (column % 3) * row;
      auto& at = cursor[column];
      while (at < keys.size() && keys[at] < lowest)
        ++at;
      for (auto j = at; j < keys.size() && keys[j] <= lowest + 2; ++j)
        if (j != i)
          adjacency.targets.push_back(static_cast<std::uint32_t>(j));
    }
    adjacency.offsets.push_back(static_cast<std::uint32_t>(adjacency.targets.size()));
  }
  return adjacency;
}

Eigen::Vector3i
cellIndex(std::uint64_t key)
{
  constexpr std::uint64_t mask = (1ull << axis_bits) - 1;
  return Eigen::Vector3i(static_cast<int>((key >> (2 * axis_bits)) & mask) - 1,
                         static_cast<int>((key >> axis_bits) & mask) - 1,
                         static_cast<int>(key & mask) - 1);
}

} // namespace pcl::indoor
