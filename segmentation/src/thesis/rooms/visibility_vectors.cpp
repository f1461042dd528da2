/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "thesis/rooms/visibility_vectors.h"

#include "rooms/space/visibility.h"

#include <pcl/indoor/threads.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <limits>

namespace pcl::indoor {
namespace {

/** Bits of a that b lacks, and bits of b's part `c` that a lacks; with b = c those that
 * differ.
 */
std::size_t
missingBits(const std::uint64_t* a,
            const std::uint64_t* b,
            const std::uint64_t* c,
            std::size_t words)
{
  std::size_t count = 0;
  for (std::size_t w = 0; w < words; ++w)
    count += __builtin_popcountll((a[w] & ~b[w]) | (c[w] & ~a[w]));
  return count;
}

void
requireInside(const GridShape& shape, const std::vector<Eigen::Vector3i>& voxels)
{
  for (const auto& v : voxels)
    if (!shape.contains(v.x(), v.y(), v.z()))
      PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                          "Voxel (" << v.x() << ", " << v.y() << ", " << v.z()
                                    << ") lies outside of the grid.");
}

} // namespace

VisibilityVectors
visibilityVectors(const VoxelMap<std::uint8_t>& occupancy,
                  const std::vector<Eigen::Vector3i>& voxels,
                  const std::vector<Eigen::Vector3i>& landmarks,
                  int threads)
{
  requireInside(occupancy.shape, voxels);
  requireInside(occupancy.shape, landmarks);
  VisibilityVectors vectors;
  vectors.count = voxels.size();
  vectors.landmarks = landmarks.size();
  vectors.words = (landmarks.size() + 63) / 64;
  vectors.bits.assign(vectors.count * vectors.words, 0);
  vectors.visible.assign(vectors.count, 0);
  const auto count = static_cast<std::ptrdiff_t>(voxels.size());
#pragma omp parallel for num_threads(usefulThreads(threads, voxels.size(), 100))       \
    schedule(dynamic, 64)
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const auto row = static_cast<std::size_t>(i);
    for (std::size_t l = 0; l < landmarks.size(); ++l)
      if (lineOfSight(occupancy, voxels[row], landmarks[l])) {
        vectors.bits[row * vectors.words + l / 64] |= std::uint64_t{1} << (l % 64);
        ++vectors.visible[row];
      }
  }
  return vectors;
}

double
visibilityDistance(const VisibilityVectors& vectors, std::size_t i, std::size_t j)
{
  const std::size_t sum =
      static_cast<std::size_t>(vectors.visible[i]) + vectors.visible[j];
  if (sum == 0)
    return 0.0;
  const std::uint64_t* other = vectors.bits.data() + j * vectors.words;
  const std::size_t differing =
      missingBits(vectors.bits.data() + i * vectors.words, other, other, vectors.words);
  return static_cast<double>(differing) / static_cast<double>(sum);
}

void
VisibilityGroup::add(const VisibilityVectors& vectors, std::size_t i)
{
  const std::uint64_t* bits = vectors.bits.data() + i * vectors.words;
  if (any.empty()) {
    all.assign(bits, bits + vectors.words);
    any = all;
  }
  for (std::size_t w = 0; w < vectors.words; ++w) {
    all[w] &= bits[w];
    any[w] |= bits[w];
  }
  most_visible = std::max(most_visible, vectors.visible[i]);
}

double
leastVisibilityDistance(const VisibilityVectors& vectors,
                        std::size_t i,
                        const VisibilityGroup& group)
{
  const std::size_t sum =
      static_cast<std::size_t>(vectors.visible[i]) + group.most_visible;
  if (sum == 0)
    return 0.0;
  const std::size_t differing = missingBits(vectors.bits.data() + i * vectors.words,
                                            group.any.data(),
                                            group.all.data(),
                                            vectors.words);
  return static_cast<double>(differing) / static_cast<double>(sum);
}

std::vector<Eigen::Vector3i>
spreadLandmarks(const PixelMap<int>& heights, int spacing)
{
  if (spacing < 1)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The spacing of landmarks must be positive, not " << spacing
                                                                          << ".");
  std::vector<Eigen::Vector3i> landmarks;
  for (int x0 = 0; x0 < heights.nx; x0 += spacing)
    for (int y0 = 0; y0 < heights.ny; y0 += spacing) {
      Eigen::Vector3i best(-1, -1, -1);
      int best_distance = std::numeric_limits<int>::max();
      for (int x = x0; x < std::min(x0 + spacing, heights.nx); ++x)
        for (int y = y0; y < std::min(y0 + spacing, heights.ny); ++y) {
          const int u = 2 * (x - x0) + 1 - spacing, v = 2 * (y - y0) + 1 - spacing;
          if (heights.at(x, y) >= 0 && u * u + v * v < best_distance) {
            best_distance = u * u + v * v;
            best = {x, y, heights.at(x, y)};
          }
        }
      if (best.z() >= 0)
        landmarks.push_back(best);
    }
  return landmarks;
}

} // namespace pcl::indoor
