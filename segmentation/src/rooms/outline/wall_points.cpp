/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/outline/wall_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace pcl::indoor {

WallPoints::WallPoints(const std::vector<Eigen::Vector2d>& points)
{
  if (points.empty())
    return;
  low_ = points.front();
  Eigen::Array2d high = low_;
  for (const auto& point : points) {
    low_ = low_.min(point.array());
    high = high.max(point.array());
  }
  // No more tiles than points, but for some along the longer side.
  const Eigen::Array2d extent = high - low_;
  const auto count = static_cast<double>(points.size());
  tile_size_ =
      std::max({8.0, std::sqrt(extent.prod() / count), extent.maxCoeff() / count});
  tiles_ = (extent / tile_size_).cast<int>() + 1;
  first_.assign(static_cast<std::size_t>(tiles_.x()) * tiles_.y() + 1, 0);
  const auto numberOf = [&](const Eigen::Vector2d& point) {
    const Eigen::Array2i tile = tileAt(point);
    return static_cast<std::size_t>(tile.x()) * tiles_.y() + tile.y();
  };
  for (const auto& point : points)
    ++first_[numberOf(point) + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  points_.resize(points.size());
  auto next = first_;
  for (const auto& point : points)
    points_[next[numberOf(point)]++] = point;
}

Eigen::Array2i
WallPoints::tileAt(const Eigen::Array2d& place) const
{
  const Eigen::Array2d last = (tiles_ - 1).cast<double>();
  return ((place - low_) / tile_size_).max(0.0).min(last).cast<int>();
}

void
WallPoints::alongLine(const Eigen::Vector2d& a,
                      const Eigen::Vector2d& b,
                      double margin,
                      std::vector<Eigen::Vector2d>& found) const
{
  found.clear();
  if (points_.empty())
    return;
  const Eigen::Vector2d& left = a.x() < b.x() ? a : b;
  const Eigen::Vector2d& right = a.x() < b.x() ? b : a;
  const Eigen::Vector2d along = right - left;
  const int from = tileAt(left.array() - margin).x();
  const int to = tileAt(right.array() + margin).x();
  // The height of the line between two places: all of it where it is nearly vertical.
  const auto at = [&](double x) -> Eigen::Vector2d {
    const double part = (x - left.x()) / std::max(along.x(), 1e-9);
    return left + std::clamp(part, 0.0, 1.0) * along;
  };
  for (int x = from; x <= to; ++x) {
    const double begin = low_.x() + x * tile_size_ - margin;
    const Eigen::Vector2d p = x == from ? left : at(begin);
    const Eigen::Vector2d q = x == to ? right : at(begin + tile_size_ + 2.0 * margin);
    const int lowest = tileAt(p.cwiseMin(q).array() - margin).y();
    const int highest = tileAt(p.cwiseMax(q).array() + margin).y();
    const std::size_t column = static_cast<std::size_t>(x) * tiles_.y();
    found.insert(found.end(),
                 points_.begin() + first_[column + lowest],
                 points_.begin() + first_[column + highest + 1]);
  }
}

} // namespace pcl::indoor
