/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>
#include <pcl/segmentation/hdbscan.h>

#include <algorithm>

namespace pcl::indoor {
namespace hdbscan_detail {

/** Throws if an option is out of its range. */
PCL_INDOOR_EXPORTS void
requireValid(const HDBSCANOptions& options);

/** Throws: a distance was negative or NaN. */
[[noreturn]] PCL_INDOOR_EXPORTS void
throwBadDistance();

inline std::size_t
minSamples(const HDBSCANOptions& options)
{
  return options.min_samples > 0 ? options.min_samples : options.min_cluster_size;
}

/** The distance to the k-th nearest point, the point itself being the first. If there
 * are fewer points, to the farthest.
 */
template <typename Distance>
std::vector<double>
coreDistances(std::size_t count, const Distance& distance, std::size_t k, int threads)
{
  std::vector<double> core(count, 0.0);
  const std::size_t others = count == 0 ? 0 : std::min(k, count) - 1;
  if (others == 0)
    return core;
  parallelFor(
      static_cast<std::ptrdiff_t>(count),
      usefulThreads(threads, count, 256),
      64,
      [] { return std::vector<double>(); }, // a heap with the farthest on top
      [&](std::vector<double>& nearest, std::ptrdiff_t row) {
        const auto i = static_cast<std::size_t>(row);
        nearest.clear();
        for (std::size_t j = 0; j < count; ++j) {
          if (j == i)
            continue;
          const double d = distance(i, j);
          if (!(d >= 0.0))
            throwBadDistance();
          if (nearest.size() < others) {
            nearest.push_back(d);
            std::push_heap(nearest.begin(), nearest.end());
          }
          else if (d < nearest.front()) {
            std::pop_heap(nearest.begin(), nearest.end());
            nearest.back() = d;
            std::push_heap(nearest.begin(), nearest.end());
          }
        }
        core[i] = nearest.front();
      });
  return core;
}

/** The same in a graph, where of parallel edges the shortest counts; infinite for a
 * point with fewer than k - 1 neighbours. Throws if an edge leaves the graph or its
 * distance is negative or NaN.
 */
PCL_INDOOR_EXPORTS std::vector<double>
graphCoreDistances(std::size_t count,
                   const std::vector<HDBSCANEdge>& edges,
                   std::size_t k);

/** A point outside of the tree and its shortest edge into it. */
struct Reachable {
  std::uint32_t point;
  std::uint32_t from;
  double distance;
};

inline bool
nearer(const Reachable& a, const Reachable& b)
{
  return a.distance < b.distance || (a.distance == b.distance && a.point < b.point);
}

/** Prim's algorithm on the mutual reachability; stores no distances but the shortest.
 * \param[in] share points that keep one thread busy between two barriers
 */
template <typename Distance>
std::vector<HDBSCANEdge>
spanningTree(const std::vector<double>& core,
             const Distance& distance,
             int threads,
             std::size_t share = 8192)
{
  const std::size_t count = core.size();
  std::vector<HDBSCANEdge> tree;
  if (count < 2)
    return tree;
  tree.reserve(count - 1);
  std::vector<Reachable> outside(count - 1);
  for (std::size_t i = 1; i < count; ++i)
    outside[i - 1] = {
        static_cast<std::uint32_t>(i), 0, std::numeric_limits<double>::infinity()};
  const Reachable nobody{std::numeric_limits<std::uint32_t>::max(),
                         0,
                         std::numeric_limits<double>::infinity()};
  std::uint32_t current = 0;
  struct State {
    Reachable best;
    std::ptrdiff_t nearest;
  };
  while (!outside.empty()) {
    const auto size = static_cast<std::ptrdiff_t>(outside.size());
    const int team = usefulThreads(threads, outside.size(), share);
    Reachable chosen = nobody;
    std::ptrdiff_t place = 0; // of the chosen
    parallelFor(
        size,
        team,
        evenChunk(size, team),
        [&nobody] {
          return State{nobody, 0};
        },
        [&](State& state, std::ptrdiff_t k) {
          Reachable& other = outside[static_cast<std::size_t>(k)];
          // mutual reachability never falls below the core distances
          const double least = std::max(core[current], core[other.point]);
          if (least < other.distance) {
            const double d = distance(current, other.point);
            if (!(d >= 0.0))
              throwBadDistance();
            const double reach = std::max(d, least);
            if (reach < other.distance) {
              other.distance = reach;
              other.from = current;
            }
          }
          if (nearer(other, state.best))
            state = {other, k};
        },
        [&](const State& state) {
          if (nearer(state.best, chosen)) {
            chosen = state.best;
            place = state.nearest;
          }
        });
    tree.push_back({chosen.from, chosen.point, chosen.distance});
    current = chosen.point;
    outside[static_cast<std::size_t>(place)] = outside.back();
    outside.pop_back();
  }
  return tree;
}

} // namespace hdbscan_detail

template <typename Distance>
HDBSCANResult
hdbscan(std::size_t count, const Distance& distance, const HDBSCANOptions& options)
{
  hdbscan_detail::requireValid(options);
  const std::vector<double> core = hdbscan_detail::coreDistances(
      count, distance, hdbscan_detail::minSamples(options), options.threads);
  return hdbscanFromSpanningForest(
      count, hdbscan_detail::spanningTree(core, distance, options.threads), options);
}

} // namespace pcl::indoor
