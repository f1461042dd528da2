/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace pcl::indoor {

/** \brief Points seen from above, in square tiles: those in a box are found without
 * looking at all.
 * \tparam Point an Eigen vector, x and y first
 */
template <typename Point>
class PointTiles {
public:
  PointTiles() = default;

  /** \param[in] points finite
   * \param[in] least_size edge of a tile, in the unit of the points; larger where
   * there would be more tiles than points
   */
  PointTiles(const std::vector<Point>& points, double least_size)
  {
    if (points.empty())
      return;
    low_ = placeOf(points.front());
    Eigen::Array2d high = low_;
    for (const Point& point : points) {
      low_ = low_.min(placeOf(point));
      high = high.max(placeOf(point));
    }
    // No more tiles than points, but for some along the longer side.
    const Eigen::Array2d extent = high - low_;
    const auto count = static_cast<double>(points.size());
    size_ = std::max(
        {least_size, std::sqrt(extent.prod() / count), extent.maxCoeff() / count});
    tiles_ = (extent / size_).template cast<int>() + 1;
    first_.assign(static_cast<std::size_t>(tiles_.x()) * tiles_.y() + 1, 0);
    const auto numberOf = [&](const Point& point) {
      const Eigen::Array2i tile = tileAt(placeOf(point));
      return static_cast<std::size_t>(tile.x()) * tiles_.y() + tile.y();
    };
    for (const Point& point : points)
      ++first_[numberOf(point) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    points_.resize(points.size());
    auto next = first_;
    for (const Point& point : points)
      points_[next[numberOf(point)]++] = point;
  }

  bool
  empty() const
  {
    return points_.empty();
  }

  /** \brief Edge of a tile. */
  double
  size() const
  {
    return size_;
  }

  /** \brief The tile at a place, the nearest one where there is none. */
  Eigen::Array2i
  tileAt(const Eigen::Array2d& place) const
  {
    const Eigen::Array2d last = (tiles_ - 1).template cast<double>();
    return ((place - low_) / size_).max(0.0).min(last).template cast<int>();
  }

  /** \brief Where the tiles of a number along x begin. */
  double
  beginOf(int x) const
  {
    return low_.x() + x * size_;
  }

  /** \brief Call visit(first, end) with the points of the tiles (x, first_y) to
   * (x, last_y). */
  template <typename Visit>
  void
  visitTiles(int x, int first_y, int last_y, const Visit& visit) const
  {
    const std::size_t column = static_cast<std::size_t>(x) * tiles_.y();
    visit(points_.data() + first_[column + first_y],
          points_.data() + first_[column + last_y + 1]);
  }

  /** \brief Call visit(first, end) with ranges of points that hold all of a box, and
   * others near it. */
  template <typename Visit>
  void
  forEachNear(const Eigen::Array2d& low,
              const Eigen::Array2d& high,
              const Visit& visit) const
  {
    if (empty())
      return;
    const Eigen::Array2i first = tileAt(low), last = tileAt(high);
    for (int x = first.x(); x <= last.x(); ++x)
      visitTiles(x, first.y(), last.y(), visit);
  }

private:
  static Eigen::Array2d
  placeOf(const Point& point)
  {
    return point.template head<2>().template cast<double>().array();
  }

  std::vector<Point> points_;      ///< tile by tile, in the order given
  std::vector<std::size_t> first_; ///< per tile, and their end
  Eigen::Array2d low_ = Eigen::Array2d::Zero();
  Eigen::Array2i tiles_ = Eigen::Array2i::Zero(); ///< along x and y; y runs fastest
  double size_ = 1.0;
};

} // namespace pcl::indoor
