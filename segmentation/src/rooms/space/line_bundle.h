/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/voxel_map.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief The discretised lines along a level direction: each column lies on exactly
 * one. Line l holds, at step i of the major axis, the column l + first + shift[i] of
 * the minor axis.
 */
struct LineBundle {
  bool along_x;           // the major axis is x
  int steps;              // length of the major axis
  int width;              // length of the minor axis
  std::vector<int> shift; // per step
  int first;              // smallest number of a line
  int count;              // number of lines

  LineBundle(const GridShape& shape, const Eigen::Vector2d& direction)
  : along_x(std::abs(direction.x()) >= std::abs(direction.y()))
  , steps(along_x ? shape.nx : shape.ny)
  , width(along_x ? shape.ny : shape.nx)
  , shift(steps)
  {
    const double slope =
        along_x ? direction.y() / direction.x() : direction.x() / direction.y();
    for (int i = 0; i < steps; ++i)
      shift[i] = static_cast<int>(std::floor(i * slope + 0.5));
    const int last = steps > 0 ? shift.back() : 0;
    first = -std::max(last, 0);
    count = width - first - std::min(last, 0);
  }

  /** \brief The place of a column's first voxel. */
  std::size_t
  column(const GridShape& shape, int step, int across) const
  {
    return along_x ? shape.index(step, across, 0) : shape.index(across, step, 0);
  }
};

} // namespace pcl::indoor
