/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "bar_cells.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace {

using pcl::indoor::CellBox;
using pcl::indoor::GridCell;

constexpr int max_empty = 2; // cells in a run
constexpr int thinness = 5;  // length of a run over that of those across it
constexpr int thin_part = 3; // one of so many cells of a run is thin

struct Run {
  int low = 0, high = 0;

  int
  length() const
  {
    return high - low + 1;
  }
};

/** Cells in the order of lines along an axis, with the run through each. */
struct Lines {
  std::vector<std::uint32_t> order; // numbers of cells
  std::vector<std::uint32_t> ends;  // of runs, exclusive, in that order
  std::vector<int> length_at;       // of the run through each cell
};

Lines
linesAlong(const std::vector<GridCell>& cells, int axis)
{
  const int second = (axis + 1) % 3, third = (axis + 2) % 3;
  Lines lines;
  lines.order.resize(cells.size());
  std::iota(lines.order.begin(), lines.order.end(), 0u);
  const auto key = [&](std::uint32_t c) {
    return GridCell{cells[c][second], cells[c][third], cells[c][axis]};
  };
  std::sort(lines.order.begin(), lines.order.end(), [&](auto a, auto b) {
    return key(a) < key(b);
  });
  const auto go_on = [&](std::uint32_t a, std::uint32_t b) {
    const auto from = key(a), to = key(b);
    return from[0] == to[0] && from[1] == to[1] && to[2] - from[2] <= max_empty + 1;
  };
  lines.length_at.resize(cells.size());
  for (std::uint32_t begin = 0, end = 0; begin < cells.size(); begin = end) {
    for (end = begin + 1;
         end < cells.size() && go_on(lines.order[end - 1], lines.order[end]);)
      ++end;
    const int length =
        cells[lines.order[end - 1]][axis] - cells[lines.order[begin]][axis] + 1;
    for (auto i = begin; i < end; ++i)
      lines.length_at[lines.order[i]] = length;
    lines.ends.push_back(end);
  }
  return lines;
}

} // namespace

namespace pcl {
namespace indoor {

std::vector<CellBox>
thinRuns(const std::vector<GridCell>& cells, int axis, double min_length)
{
  const auto along = linesAlong(cells, axis),
             across = linesAlong(cells, (axis + 1) % 3),
             third = linesAlong(cells, (axis + 2) % 3);
  std::vector<CellBox> runs;
  std::uint32_t begin = 0;
  for (const auto end : along.ends) {
    const auto first = along.order[begin];
    const int length = along.length_at[first];
    const auto thin = std::count_if(
        along.order.begin() + begin, along.order.begin() + end, [&](auto c) {
          return thinness * std::max(across.length_at[c], third.length_at[c]) <= length;
        });
    if (length >= min_length && thin_part * thin >= static_cast<int>(end - begin))
      runs.push_back({cells[first], cells[along.order[end - 1]]});
    begin = end;
  }
  return runs;
}

} // namespace indoor
} // namespace pcl
