/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/distance_map.h"

#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>

#include <algorithm>

namespace pcl::indoor {
namespace {

/** Lower envelope of the parabolas f(v) + (u - v)^2 over the integers of one line. */
class LineTransform {
public:
  explicit LineTransform(int length)
  : vertex_(length)
  , start_(length)
  , half_reciprocal_(length)
  {
    for (int i = 1; i < length; ++i)
      half_reciprocal_[i] = 0.5 / i;
  }

  /** Replaces a line of squared distances across it by those in the plane. */
  void
  apply(std::uint32_t* line, int length)
  {
    int last = -1; // of the parabolas on the envelope
    heights_.assign(line, line + length);
    for (int u = 0; u < length; ++u) {
      if (heights_[u] == kNoObstacle)
        continue;
      int from = 0;
      while (last >= 0) {
        from = firstWhereBelow(vertex_[last], u);
        if (from > start_[last])
          break;
        --last;
      }
      if (last < 0)
        from = 0;
      if (from >= length)
        continue;
      ++last;
      vertex_[last] = u;
      start_[last] = from;
    }
    if (last < 0)
      return; // no obstacle at all
    for (int k = 0, u = 0; k <= last; ++k) {
      const int end = k < last ? start_[k + 1] : length;
      const int v = vertex_[k];
      const std::uint64_t height = heights_[v];
      for (; u < end; ++u) {
        const std::int64_t along = u - v;
        line[u] = static_cast<std::uint32_t>(std::min<std::uint64_t>(
            height + static_cast<std::uint64_t>(along * along), kNoObstacle - 1));
      }
    }
  }

private:
  /** The first integer at which the parabola of v lies below that of u < v.
   * The quotient is rational with a denominator of at most twice the length: double
   * precision cannot carry it over an integer; at an integer both parabolas are equal.
   */
  int
  firstWhereBelow(int u, int v) const
  {
    const double rise =
        static_cast<double>(heights_[v]) - static_cast<double>(heights_[u]);
    const double crossing =
        0.5 * (u + v) + rise * half_reciprocal_[static_cast<std::size_t>(v - u)];
    if (crossing < 0.0)
      return 0;
    if (crossing >= 1e9)
      return 1000000000;
    return static_cast<int>(crossing) + 1;
  }

  std::vector<std::uint32_t> heights_;
  std::vector<int> vertex_, start_;
  std::vector<double> half_reciprocal_;
};

constexpr std::size_t batch = 16; // lines taken together: a cache line of values

} // namespace

void
transformAlong(std::vector<std::uint32_t>& values,
               std::size_t slabs,
               std::size_t slab_stride,
               std::size_t lines,
               std::size_t stride,
               int length,
               int threads)
{
  const std::size_t batches = (lines + batch - 1) / batch;
  const auto jobs = static_cast<std::ptrdiff_t>(slabs * batches);
  struct State {
    LineTransform transform;
    std::vector<std::uint32_t> buffer;
  };
  parallelFor(
      jobs,
      threads,
      evenChunk(jobs, threads),
      [length] {
        return State{
            LineTransform(length),
            std::vector<std::uint32_t>(batch * static_cast<std::size_t>(length))};
      },
      [&](State& state, std::ptrdiff_t job) {
        auto& [transform, buffer] = state;
        const std::size_t slab = static_cast<std::size_t>(job) / batches;
        const std::size_t first = static_cast<std::size_t>(job) % batches * batch;
        const std::size_t width = std::min(batch, lines - first);
        std::uint32_t* start = values.data() + slab * slab_stride + first;
        const auto size = static_cast<std::size_t>(length);
        for (std::size_t k = 0; k < size; ++k)
          for (std::size_t j = 0; j < width; ++j)
            buffer[j * size + k] = start[k * stride + j];
        for (std::size_t j = 0; j < width; ++j)
          transform.apply(buffer.data() + j * size, length);
        for (std::size_t k = 0; k < size; ++k)
          for (std::size_t j = 0; j < width; ++j)
            start[k * stride + j] = buffer[j * size + k];
      });
}

PixelMap<std::uint32_t>
squaredDistanceMap(const PixelMap<std::uint8_t>& obstacles, int threads)
{
  PixelMap<std::uint32_t> map{
      obstacles.nx, obstacles.ny, std::vector<std::uint32_t>(obstacles.size())};
  std::transform(obstacles.values.begin(),
                 obstacles.values.end(),
                 map.values.begin(),
                 [](std::uint8_t o) { return o ? 0u : kNoObstacle; });
  const auto nx = static_cast<std::size_t>(map.nx);
  const auto ny = static_cast<std::size_t>(map.ny);
  const int count = usefulThreads(threads, nx * ny, 2000);
  transformAlong(map.values, nx, ny, 1, 1, map.ny, count);
  transformAlong(map.values, 1, 0, ny, ny, map.nx, count);
  return map;
}

} // namespace pcl::indoor
