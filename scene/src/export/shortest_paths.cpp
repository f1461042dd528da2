/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/shortest_paths.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace pcl::indoor::tool {

std::vector<std::size_t>
PathsFrom::to(std::size_t point) const
{
  if (lengths[point] == std::numeric_limits<double>::infinity())
    return {};
  std::vector<std::size_t> path = {point};
  while (previous[path.back()] != path.back())
    path.push_back(previous[path.back()]);
  std::reverse(path.begin(), path.end());
  return path;
}

ShortestPaths::ShortestPaths(std::size_t point_count,
                             const std::vector<WeightedLine>& lines)
: ways_(point_count)
{
  for (const auto& line : lines) {
    ways_[line.a].push_back({line.b, line.length});
    ways_[line.b].push_back({line.a, line.length});
  }
}

PathsFrom
ShortestPaths::from(std::size_t start) const
{
  PathsFrom paths;
  paths.lengths.assign(ways_.size(), std::numeric_limits<double>::infinity());
  paths.previous.assign(ways_.size(), start);
  paths.lengths[start] = 0.0;
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> next;
  next.push({0.0, start});
  while (!next.empty()) {
    const auto [length, point] = next.top();
    next.pop();
    if (length > paths.lengths[point])
      continue;
    for (const auto& way : ways_[point]) {
      const double longer = length + way.length;
      if (longer < paths.lengths[way.to]) {
        paths.lengths[way.to] = longer;
        paths.previous[way.to] = point;
        next.push({longer, way.to});
      }
    }
  }
  return paths;
}

} // namespace pcl::indoor::tool
