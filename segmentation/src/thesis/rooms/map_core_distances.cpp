/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "thesis/rooms/map_blocks.h"

#include "thesis/rooms/map_clustering.h"

#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>

#include <algorithm>
#include <limits>

namespace pcl::indoor {
namespace {

/** The k smallest distances of a point, the largest on top. */
class Nearest {
public:
  explicit Nearest(std::size_t k)
  : k_(k)
  {}

  void
  clear()
  {
    heap_.clear();
  }

  double
  bound() const
  {
    return heap_.size() < k_ ? std::numeric_limits<double>::infinity() : heap_.front();
  }

  void
  add(double d)
  {
    if (heap_.size() == k_) {
      std::pop_heap(heap_.begin(), heap_.end());
      heap_.pop_back();
    }
    heap_.push_back(d);
    std::push_heap(heap_.begin(), heap_.end());
  }

private:
  std::size_t k_;
  std::vector<double> heap_;
};

} // namespace

std::vector<double>
mapCoreDistances(const MapDistance& distance, std::size_t min_samples, int threads)
{
  const std::size_t count = distance.size();
  std::vector<double> core(count, 0.0);
  const std::size_t others =
      count == 0 || min_samples == 0 ? 0 : std::min(min_samples, count) - 1;
  if (others == 0)
    return core;
  const MapBlocks blocks(distance);
  const auto& own = distance.connectivity().ownLevels();
  parallelFor(
      static_cast<std::ptrdiff_t>(count),
      usefulThreads(threads, count, 1000),
      256,
      [others] { return Nearest(others); },
      [&](Nearest& nearest, std::ptrdiff_t row) {
        const auto i = static_cast<std::size_t>(row);
        const float level =
            own[distance.pixels()[i]]; // nobody is connected at a higher
        nearest.clear();
        const auto tooFar = [&](double pixels, float highest) {
          return (distance.euclideanPart(pixels) + distance.fieldPart(highest)) *
                     safely >=
                 nearest.bound();
        };
        blocks.forEachAround(
            i,
            [&](double pixels) { return tooFar(pixels, level); },
            [&](std::size_t block, double gap) {
              if (tooFar(gap, std::min(level, blocks.maxLevel(block))))
                return;
              blocks.forEachPoint(block, [&](std::size_t j) {
                if (j == i)
                  return;
                const double known = distance.reachable(i, j);
                if (known >= nearest.bound())
                  return;
                const double d = known + distance.visibilityPart(i, j);
                if (d < nearest.bound())
                  nearest.add(d);
              });
            });
        core[i] = nearest.bound();
      });
  return core;
}

} // namespace pcl::indoor
