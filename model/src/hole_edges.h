/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/model/wall_image.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

// The edges of a hole are numbered: 0 left, 1 right, 2 above, 3 below.

/** \brief Length of the pieces of an edge that are seen or not: metres, at least three
 * cells. */
inline double
edgePiece(const WallImage& image)
{
  return std::max(0.1, 3.0 * image.cell);
}

/** \brief The share of an edge's pieces that are seen. */
inline double
seenShareOf(const std::vector<std::uint8_t>& pieces)
{
  return static_cast<double>(std::count(pieces.begin(), pieces.end(), 1)) /
         static_cast<double>(pieces.size());
}

/** \brief Call visit(edge, beyond, along) with how far a point lies beyond each edge of
 * a box, and where along it, metres. */
template <typename Visit>
void
forEachEdge(const Eigen::AlignedBox2d& box, const WallPoint& point, const Visit& visit)
{
  const Eigen::Vector2d &low = box.min(), &high = box.max();
  const double u = point.along, v = point.height;
  visit(0, low.x() - u, v - low.y());
  visit(1, u - high.x(), v - low.y());
  visit(2, v - high.y(), u - low.x());
  visit(3, low.y() - v, u - low.x());
}

} // namespace pcl::indoor
