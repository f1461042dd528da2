/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/outline/wall_points.h"

#include <algorithm>
#include <vector>

namespace pcl::indoor {

WallPoints::WallPoints(const std::vector<Eigen::Vector2d>& points)
: tiles_(points, 8.0) // pixels, at least
{}

void
WallPoints::alongLine(const Eigen::Vector2d& a,
                      const Eigen::Vector2d& b,
                      double margin,
                      std::vector<Eigen::Vector2d>& found) const
{
  found.clear();
  if (tiles_.empty())
    return;
  const Eigen::Vector2d& left = a.x() < b.x() ? a : b;
  const Eigen::Vector2d& right = a.x() < b.x() ? b : a;
  const Eigen::Vector2d along = right - left;
  const int from = tiles_.tileAt(left.array() - margin).x();
  const int to = tiles_.tileAt(right.array() + margin).x();
  // The height of the line between two places: all of it where it is nearly vertical.
  const auto at = [&](double x) -> Eigen::Vector2d {
    const double part = (x - left.x()) / std::max(along.x(), 1e-9);
    return left + std::clamp(part, 0.0, 1.0) * along;
  };
  for (int x = from; x <= to; ++x) {
    const double begin = tiles_.beginOf(x) - margin;
    const Eigen::Vector2d p = x == from ? left : at(begin);
    const Eigen::Vector2d q =
        x == to ? right : at(begin + tiles_.size() + 2.0 * margin);
    const int lowest = tiles_.tileAt(p.cwiseMin(q).array() - margin).y();
    const int highest = tiles_.tileAt(p.cwiseMax(q).array() + margin).y();
    tiles_.visitTiles(x, lowest, highest, [&](const auto* first, const auto* end) {
      found.insert(found.end(), first, end);
    });
  }
}

} // namespace pcl::indoor
