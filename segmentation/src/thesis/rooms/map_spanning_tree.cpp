/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "thesis/rooms/map_blocks.h"

#include "rooms/space/map_regions.h"
#include "thesis/rooms/map_clustering.h"

#include <pcl/indoor/disjoint_sets.h>
#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>

namespace pcl::indoor {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/** Boruvka's algorithm: in each round every component takes its shortest edge outwards.
 * What keeps that cheap is that the ultrametric of the field tells for each pixel how
 * near a pixel of another component can possibly be.
 */
class SpanningTreeBuilder {
public:
  SpanningTreeBuilder(const MapDistance& distance,
                      const std::vector<double>& core,
                      int threads)
  : distance_(distance)
  , core_(core)
  , threads_(threads)
  , blocks_(distance)
  , sets_(core.size())
  , component_(core.size())
  , least_(core)
  , candidate_(core.size())
  , candidate_reach_(core.size(), infinity)
  , foreign_part_(core.size())
  , best_(core.size())
  , block_component_(blocks_.count())
  , block_core_(blocks_.count(), infinity)
  {
    orderByField();
    place_ = PixelMap<std::uint32_t>::filled(
        distance.mapWidth(), distance.mapHeight(), kNobody);
    for (std::size_t i = 0; i < core.size(); ++i) {
      place_.values[distance.pixels()[i]] = static_cast<std::uint32_t>(i);
      double& smallest = block_core_[blocks_.blockOf(i)];
      smallest = std::min(smallest, core[i]);
    }
  }

  std::vector<HDBSCANEdge>
  build()
  {
    const std::size_t count = core_.size();
    if (count < 2)
      return {};
    tree_.reserve(count - 1);
    linkToDenserNeighbours();
    while (tree_.size() + 1 < count) {
      prepareRound();
      const auto points = static_cast<std::ptrdiff_t>(count);
      parallelFor(points, threads_, 256, [this](std::ptrdiff_t i) {
        searchOutwards(static_cast<std::size_t>(i));
      });
      const std::size_t before = tree_.size();
      takeShortestEdges();
      if (tree_.size() == before)
        break; // the rest is infinitely far
    }
    return std::move(tree_);
  }

private:
  static constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();

  double
  reach(std::size_t i, std::size_t j) const
  {
    return std::max({distance_(i, j), core_[i], core_[j]});
  }

  /** The points in the row of the field's connectivity, with the levels between them.
   */
  void
  orderByField()
  {
    const auto& connectivity = distance_.connectivity();
    const auto& pixels = distance_.pixels();
    std::vector<std::uint32_t> in_row(connectivity.positions().size(), kNobody);
    for (std::size_t i = 0; i < pixels.size(); ++i)
      in_row[static_cast<std::size_t>(connectivity.positions()[pixels[i]])] =
          static_cast<std::uint32_t>(i);
    float level = 0.0f;
    for (std::size_t p = 0; p < in_row.size(); ++p) {
      if (in_row[p] != kNobody) {
        row_.push_back(in_row[p]);
        row_levels_.push_back(level); // to the one before
        level = std::numeric_limits<float>::infinity();
      }
      level = std::min(level, connectivity.gaps()[p]);
    }
  }

  template <typename Visit>
  void
  forEachNeighbour(std::size_t i, const Visit& visit) const
  {
    const std::size_t pixel = distance_.pixels()[i];
    indoor::forEachNeighbour(place_, pixel, Neighbours::Eight, [&](std::size_t other) {
      if (const std::uint32_t j = place_.values[other]; j != kNobody)
        visit(static_cast<std::size_t>(j));
    });
  }

  void
  join(std::size_t i, std::size_t j, double reach)
  {
    const std::uint32_t a = sets_.find(static_cast<std::uint32_t>(i));
    const std::uint32_t b = sets_.find(static_cast<std::uint32_t>(j));
    if (a == b)
      return;
    sets_.merge(a, b);
    tree_.push_back(
        {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), reach});
  }

  /** No edge of a point is shorter than its core distance: one of that length to a
   * point of a smaller core distance (or as small, with a smaller number) is a shortest
   * one, and such edges form no cycle.
   */
  void
  linkToDenserNeighbours()
  {
    for (std::size_t i = 0; i < core_.size(); ++i) {
      bool linked = core_[i] == infinity;
      forEachNeighbour(i, [&](std::size_t j) {
        const bool denser = core_[j] < core_[i] || (core_[j] == core_[i] && j < i);
        if (linked || !denser || distance_(i, j) > core_[i])
          return;
        join(i, j, core_[i]);
        linked = true;
      });
    }
  }

  void
  prepareRound()
  {
    for (std::size_t i = 0; i < component_.size(); ++i) {
      component_[i] = sets_.find(static_cast<std::uint32_t>(i));
      best_[i].store(infinity, std::memory_order_relaxed);
    }
    boundForeignLevels();
    std::fill(block_component_.begin(), block_component_.end(), kNobody);
    std::vector<char> seen(block_component_.size(), 0);
    for (std::size_t i = 0; i < component_.size(); ++i) {
      const std::size_t b = blocks_.blockOf(i);
      if (!seen[b])
        block_component_[b] = component_[i];
      else if (block_component_[b] != component_[i])
        block_component_[b] = kNobody; // several
      seen[b] = 1;
    }
    for (std::size_t i = 0; i < component_.size(); ++i) {
      if (candidate_reach_[i] < infinity && component_[candidate_[i]] == component_[i])
        candidate_reach_[i] = infinity; // joined meanwhile
      forEachNeighbour(i, [&](std::size_t j) {
        if (component_[j] != component_[i] && std::max(core_[i], core_[j]) < bestOf(i))
          offer(i, j, reach(i, j));
      });
      if (candidate_reach_[i] < infinity)
        lower(best_[component_[i]], candidate_reach_[i]);
    }
  }

  /** The highest level at which each point is connected to one of another component:
   * the row's nearest foreign point on either side is connected highest.
   */
  void
  boundForeignLevels()
  {
    std::vector<float> foreign(row_.size(), 0.0f);
    float level = 0.0f;
    for (std::size_t p = 1; p < row_.size(); ++p) {
      level = component_[row_[p]] == component_[row_[p - 1]]
                  ? std::min(level, row_levels_[p])
                  : row_levels_[p];
      foreign[p] = level;
    }
    level = 0.0f;
    for (std::size_t p = row_.size() - 1; p > 0; --p) {
      level = component_[row_[p]] == component_[row_[p - 1]]
                  ? std::min(level, row_levels_[p])
                  : row_levels_[p];
      foreign[p - 1] = std::max(foreign[p - 1], level);
    }
    for (std::size_t p = 0; p < row_.size(); ++p)
      foreign_part_[row_[p]] = distance_.fieldPart(foreign[p]);
  }

  double
  bestOf(std::size_t i) const
  {
    return best_[component_[i]].load(std::memory_order_relaxed);
  }

  static void
  lower(std::atomic<double>& best, double value)
  {
    double seen = best.load(std::memory_order_relaxed);
    while (value < seen &&
           !best.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {
    }
  }

  void
  offer(std::size_t i, std::size_t j, double reach)
  {
    if (reach >= candidate_reach_[i])
      return;
    candidate_reach_[i] = reach;
    candidate_[i] = static_cast<std::uint32_t>(j);
    lower(best_[component_[i]], reach);
  }

  /** Finds the shortest edge of a point out of its component if that is shorter than
   * all that are known of the component.
   */
  void
  searchOutwards(std::size_t i)
  {
    const double field_part = foreign_part_[i];
    const auto tooFar = [&](double pixels) {
      const double least =
          std::max(core_[i], (field_part + distance_.euclideanPart(pixels)) * safely);
      return least >= bestOf(i);
    };
    if (least_[i] >= bestOf(i) || tooFar(1.0))
      return;
    blocks_.forEachAround(i, tooFar, [&](std::size_t block, double gap) {
      if (block_component_[block] == component_[i] || block_core_[block] >= bestOf(i) ||
          tooFar(gap))
        return;
      const double near = field_part + distance_.euclideanPart(gap) +
                          distance_.leastVisibilityPart(i, blocks_.view(block));
      if (near * safely >= bestOf(i))
        return;
      blocks_.forEachPoint(block, [&](std::size_t j) {
        if (component_[j] == component_[i] || core_[j] >= bestOf(i))
          return;
        // each lies in another component than the other; cheap parts first
        double least = std::max(field_part, foreign_part_[j]) +
                       distance_.euclideanPart(distance_.pixelsBetween(i, j));
        if (least * safely >= bestOf(i))
          return;
        least += distance_.visibilityPart(i, j);
        if (least * safely < bestOf(i))
          offer(i, j, reach(i, j));
      });
    });
    least_[i] = std::max(least_[i], bestOf(i)); // nothing shorter leads outwards
  }

  void
  takeShortestEdges()
  {
    for (std::size_t i = 0; i < component_.size(); ++i)
      if (candidate_reach_[i] < infinity && candidate_reach_[i] == bestOf(i)) {
        best_[component_[i]].store(-1.0, std::memory_order_relaxed); // taken
        join(i, candidate_[i], candidate_reach_[i]);
      }
  }

  const MapDistance& distance_;
  const std::vector<double>& core_;
  int threads_;
  MapBlocks blocks_;
  DisjointSets sets_;
  std::vector<HDBSCANEdge> tree_;
  PixelMap<std::uint32_t> place_;  // the point of each pixel of the map
  std::vector<std::uint32_t> row_; // the points as the field connects them
  std::vector<float> row_levels_;
  std::vector<std::uint32_t> component_;  // of each point in this round
  std::vector<double> least_;             // no edge outwards is shorter, for ever
  std::vector<std::uint32_t> candidate_;  // end of the shortest known edge outwards
  std::vector<double> candidate_reach_;   // its length
  std::vector<double> foreign_part_;      // least field part of a distance outwards
  std::vector<std::atomic<double>> best_; // the shortest known of each component
  std::vector<std::uint32_t> block_component_;
  std::vector<double> block_core_;
};

} // namespace

std::vector<HDBSCANEdge>
mapSpanningTree(const MapDistance& distance,
                const std::vector<double>& core_distances,
                int threads)
{
  return SpanningTreeBuilder(distance,
                             core_distances,
                             usefulThreads(threads, core_distances.size(), 1000))
      .build();
}

} // namespace pcl::indoor
