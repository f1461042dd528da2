/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "thesis/rooms/map_clustering.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace pcl::indoor {

/** Lower bounds of distances are rounded differently than the distances themselves. */
constexpr double safely = 1.0 - 1e-12;

/** \brief The pixels of a map in square blocks, to look around one of them. */
class MapBlocks {
public:
  explicit MapBlocks(const MapDistance& distance)
  : distance_(distance)
  , nx_((distance.mapWidth() + block_edge - 1) / block_edge)
  , ny_((distance.mapHeight() + block_edge - 1) / block_edge)
  , begin_(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_) + 1, 0)
  , points_(distance.size())
  , max_level_(begin_.size() - 1, 0.0f)
  , view_(max_level_.size())
  {
    const auto& own = distance.connectivity().ownLevels();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const std::size_t b = blockOf(i);
      ++begin_[b + 1];
      max_level_[b] = std::max(max_level_[b], own[distance.pixels()[i]]);
      if (distance.visibility().count > 0)
        view_[b].add(distance.visibility(), i);
    }
    for (std::size_t b = 0; b + 1 < begin_.size(); ++b)
      begin_[b + 1] += begin_[b];
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < points_.size(); ++i)
      points_[next[blockOf(i)]++] = static_cast<std::uint32_t>(i);
  }

  std::size_t
  count() const
  {
    return max_level_.size();
  }

  std::size_t
  blockOf(std::size_t i) const
  {
    return static_cast<std::size_t>(distance_.x(i) / block_edge) *
               static_cast<std::size_t>(ny_) +
           static_cast<std::size_t>(distance_.y(i) / block_edge);
  }

  /** What the points of a block see. */
  const VisibilityGroup&
  view(std::size_t block) const
  {
    return view_[block];
  }

  float
  maxLevel(std::size_t block) const
  {
    return max_level_[block];
  }

  template <typename Visit>
  void
  forEachPoint(std::size_t block, const Visit& visit) const
  {
    for (std::uint32_t k = begin_[block]; k < begin_[block + 1]; ++k)
      visit(static_cast<std::size_t>(points_[k]));
  }

  /** Calls visit(block, distance to it in pixels) for the blocks around a point, in
   * rings of growing distance, until enough(smallest distance in the ring) says so.
   */
  template <typename Enough, typename Visit>
  void
  forEachAround(std::size_t i, const Enough& enough, const Visit& visit) const
  {
    const int x = distance_.x(i), y = distance_.y(i);
    const int bx = x / block_edge, by = y / block_edge;
    const int rings = std::max({bx, nx_ - 1 - bx, by, ny_ - 1 - by});
    for (int ring = 0; ring <= rings; ++ring) {
      // the nearest side of the ring, in pixels from the point
      const int dx = std::min(x % block_edge, block_edge - 1 - x % block_edge);
      const int dy = std::min(y % block_edge, block_edge - 1 - y % block_edge);
      if (ring > 0 && enough((ring - 1) * block_edge + std::min(dx, dy) + 1))
        return;
      for (int u = std::max(bx - ring, 0); u <= std::min(bx + ring, nx_ - 1); ++u) {
        const bool whole = std::abs(u - bx) == ring; // else only its two ends
        for (int v = by - ring; v <= by + ring; v += whole || ring == 0 ? 1 : 2 * ring)
          if (v >= 0 && v < ny_)
            visit(static_cast<std::size_t>(u) * static_cast<std::size_t>(ny_) +
                      static_cast<std::size_t>(v),
                  gap(x, u, y, v));
      }
    }
  }

private:
  static constexpr int block_edge = 8; // pixels along the edge of a block

  static double
  gap(int x, int u, int y, int v)
  {
    const int dx =
        std::max({u * block_edge - x, x - (u * block_edge + block_edge - 1), 0});
    const int dy =
        std::max({v * block_edge - y, y - (v * block_edge + block_edge - 1), 0});
    return std::sqrt(static_cast<double>(dx) * dx + static_cast<double>(dy) * dy);
  }

  const MapDistance& distance_;
  int nx_, ny_;
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> points_;
  std::vector<float> max_level_;
  std::vector<VisibilityGroup> view_;
};

} // namespace pcl::indoor
