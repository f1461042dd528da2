/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "bar_cells.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace {

constexpr int max_empty = 1; // cells in a run
constexpr int thinness = 5;  // length of a run over that of those across it
constexpr int thin_part = 3; // one of so many cells of a run is thin

} // namespace

namespace pcl {
namespace indoor {

CellRuns::CellRuns(std::vector<GridCell> cells)
: cells_(std::move(cells))
{
  for (int axis = 0; axis < 3; ++axis)
    findRuns(axis);
}

void
CellRuns::findRuns(int axis)
{
  const int second = (axis + 1) % 3, third = (axis + 2) % 3;
  const auto key = [&](std::uint32_t c) {
    return GridCell{cells_[c][second], cells_[c][third], cells_[c][axis]};
  };
  const auto go_on = [&](std::uint32_t a, std::uint32_t b) {
    const auto from = key(a), to = key(b);
    return from[0] == to[0] && from[1] == to[1] && to[2] - from[2] <= max_empty + 1;
  };
  auto& [order, ends, length_at] = lines_[axis];
  order.resize(cells_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(
      order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  length_at.resize(cells_.size());
  for (std::uint32_t begin = 0, end = 0; begin < cells_.size(); begin = end) {
    for (end = begin + 1; end < cells_.size() && go_on(order[end - 1], order[end]);)
      ++end;
    const int length = cells_[order[end - 1]][axis] - cells_[order[begin]][axis] + 1;
    for (auto i = begin; i < end; ++i)
      length_at[order[i]] = length;
    ends.push_back(end);
  }
}

std::vector<CellBox>
CellRuns::thinAlong(int axis, double min_length) const
{
  const auto& [order, ends, length_at] = lines_[axis];
  const auto& across = lines_[(axis + 1) % 3].length_at;
  const auto& third = lines_[(axis + 2) % 3].length_at;
  std::vector<CellBox> runs;
  std::uint32_t begin = 0;
  for (const auto end : ends) {
    const int length = length_at[order[begin]];
    int thin = 0;
    for (auto i = begin; i < end; ++i)
      thin += thinness * std::max(across[order[i]], third[order[i]]) <= length;
    if (length >= min_length && thin_part * thin >= static_cast<int>(end - begin))
      runs.push_back({cells_[order[begin]], cells_[order[end - 1]]});
    begin = end;
  }
  return runs;
}

} // namespace indoor
} // namespace pcl
