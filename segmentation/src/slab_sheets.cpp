/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "slab_sheets.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl {
namespace indoor {

namespace {

constexpr double wall_thickness = 0.5; // a sheet goes on behind walls, metres

/** \brief The groups of a column: occupied runs with less than the clearance between
 * them belong together; the lowest and the highest group have nothing beyond them.
 */
void
addGroups(const std::uint8_t* column,
          int x,
          int y,
          int nz,
          int clearance,
          int max_height,
          std::vector<SlabGroup>& groups)
{
  SlabGroup group{x, y, -1, -1};
  bool is_lowest = true;
  for (int z = 0; z < nz; ++z) {
    if (!column[z])
      continue;
    if (group.low >= 0 && z - group.high - 1 >= clearance) {
      if (!is_lowest && group.high - group.low < max_height)
        groups.push_back(group);
      is_lowest = false;
      group.low = -1;
    }
    if (group.low < 0)
      group.low = z;
    group.high = z;
  }
}

std::size_t
rootOf(std::vector<std::size_t>& parents, std::size_t node)
{
  while (parents[node] != node)
    node = parents[node] = parents[parents[node]];
  return node;
}

double
median(std::vector<int> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** \brief Join groups of near columns that overlap in height. */
std::vector<std::size_t>
joinGroups(const GridShape& shape, const std::vector<SlabGroup>& groups, int reach)
{
  // Groups are sorted by column: first[c] ... first[c + 1] - 1 lie in column c.
  const std::size_t columns = static_cast<std::size_t>(shape.nx) * shape.ny;
  const auto column = [&](int x, int y) {
    return static_cast<std::size_t>(x) * shape.ny + y;
  };
  std::vector<std::size_t> first(columns + 1, 0);
  for (const auto& group : groups)
    ++first[column(group.x, group.y) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::size_t> parents(groups.size());
  std::iota(parents.begin(), parents.end(), std::size_t{0});
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const SlabGroup& group = groups[g];
    for (int x = group.x; x <= std::min(group.x + reach, shape.nx - 1); ++x)
      for (int y = std::max(group.y - reach, 0);
           y <= std::min(group.y + reach, shape.ny - 1);
           ++y)
        for (std::size_t o = first[column(x, y)]; o < first[column(x, y) + 1]; ++o) {
          if (groups[o].low > group.high || group.low > groups[o].high)
            continue;
          const std::size_t a = rootOf(parents, g);
          const std::size_t b = rootOf(parents, o);
          parents[std::max(a, b)] = std::min(a, b);
        }
  }
  for (std::size_t g = 0; g < groups.size(); ++g)
    parents[g] = rootOf(parents, g);
  return parents;
}

} // namespace

std::vector<SlabSheet>
findSlabSheets(const VoxelGrid<std::uint8_t>& occupancy, const StoreyOptions& options)
{
  const GridShape& shape = occupancy.shape;
  const double size = occupancy.voxel_size;
  const int clearance =
      std::max(1, static_cast<int>(std::lround(options.min_clearance / size)));
  const int max_height = 1 + static_cast<int>(std::lround(options.max_slab / size));
  std::vector<SlabGroup> groups;
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y)
      addGroups(&occupancy.values[shape.index(x, y, 0)],
                x,
                y,
                shape.nz,
                clearance,
                max_height,
                groups);
  const int reach = 1 + static_cast<int>(std::lround(wall_thickness / size));
  const auto roots = joinGroups(shape, groups, reach);
  std::vector<std::size_t> counts(groups.size(), 0);
  for (const std::size_t root : roots)
    ++counts[root];
  std::vector<SlabSheet> sheets;
  std::vector<std::size_t> number(groups.size(), 0);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::size_t root = roots[g];
    if (static_cast<double>(counts[root]) * size * size < options.min_slab_area)
      continue;
    if (g == root) {
      number[root] = sheets.size();
      sheets.emplace_back();
    }
    sheets[number[root]].groups.push_back(groups[g]);
  }
  for (auto& sheet : sheets) {
    std::vector<int> lows;
    std::vector<int> highs;
    for (const auto& group : sheet.groups) {
      lows.push_back(group.low);
      highs.push_back(group.high);
    }
    sheet.low = median(lows);
    sheet.high = median(highs);
  }
  return sheets;
}

} // namespace indoor
} // namespace pcl
