/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "thesis/rooms/map_labels.h"

#include "rooms/space/map_regions.h"

#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

namespace pcl::indoor {
namespace {

struct Offset {
  int x, y, z;
  int distance; // squared
};

/** All voxels of a ball but its middle, nearest first. */
std::vector<Offset>
ball(int radius)
{
  std::vector<Offset> offsets;
  for (int x = -radius; x <= radius; ++x)
    for (int y = -radius; y <= radius; ++y)
      for (int z = -radius; z <= radius; ++z) {
        const int distance = x * x + y * y + z * z;
        if (distance > 0 && distance <= radius * radius)
          offsets.push_back({x, y, z, distance});
      }
  std::sort(offsets.begin(), offsets.end(), [](const Offset& a, const Offset& b) {
    return a.distance < b.distance;
  });
  return offsets;
}

/** Counts the votes for a handful of labels. */
class Ballot {
public:
  void
  clear()
  {
    candidates_.clear();
    votes_ = 0;
  }

  void
  vote(int label, int squared_distance)
  {
    ++votes_;
    for (auto& candidate : candidates_)
      if (candidate.label == label) {
        ++candidate.votes;
        candidate.distance += squared_distance;
        return;
      }
    candidates_.push_back({label, 1, squared_distance});
  }

  std::size_t
  votes() const
  {
    return votes_;
  }

  int
  winner() const
  {
    const auto best = std::min_element(
        candidates_.begin(), candidates_.end(), [](const auto& a, const auto& b) {
          if (a.votes != b.votes)
            return a.votes > b.votes;
          return a.distance != b.distance ? a.distance < b.distance : a.label < b.label;
        });
    return best == candidates_.end() ? -1 : best->label;
  }

private:
  struct Candidate {
    int label;
    std::size_t votes;
    std::int64_t distance;
  };
  std::vector<Candidate> candidates_;
  std::size_t votes_ = 0;
};

void
requireMatching(const VoxelMap<std::uint8_t>& occupancy,
                const VoxelMap<std::uint8_t>& interior,
                const PixelMap<int>& labels)
{
  if (occupancy.shape != interior.shape || occupancy.shape.nx != labels.nx ||
      occupancy.shape.ny != labels.ny)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The occupancy, interior and map are not of one size.");
}

/** The labelled pixels, and those from which the field does not fall on the way to one:
 * 1, else 0. */
std::vector<char>
slopesOfLabels(const PixelMap<int>& labels, const PixelMap<float>& field)
{
  std::vector<char> slope(labels.size(), 0);
  std::vector<std::size_t> reached;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels.values[i] != -1) {
      slope[i] = 1;
      reached.push_back(i);
    }
  floodFill(reached, neighboursIn(labels), [&](std::size_t i, std::size_t from) {
    return field.values[i] <= field.values[from] && !std::exchange(slope[i], 1);
  });
  return slope;
}

} // namespace

PixelMap<int>
labelPeaks(const PixelMap<int>& labels,
           const PixelMap<float>& field,
           float threshold,
           std::size_t min_pixels,
           PeakPlaces places)
{
  if (labels.nx != field.nx || labels.ny != field.ny)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The labels and the field are not of one size.");
  PixelMap<int> result = labels;
  int next = 0;
  for (const int label : labels.values)
    next = std::max(next, label + 1);
  std::vector<char> seen(labels.size(), 0);
  if (places == PeakPlaces::OffSlopes)
    seen = slopesOfLabels(labels, field);
  else
    for (std::size_t i = 0; i < labels.size(); ++i)
      seen[i] = labels.values[i] != -1;
  const auto take = [&](std::size_t i, std::size_t) {
    return field.values[i] >= threshold && !std::exchange(seen[i], 1);
  };
  std::vector<std::size_t> component;
  for (std::size_t seed = 0; seed < result.size(); ++seed) {
    if (!take(seed, seed))
      continue;
    component.assign(1, seed);
    floodFill(component, neighboursIn(labels), take);
    if (component.size() < min_pixels)
      continue;
    for (const std::size_t pixel : component)
      result.values[pixel] = next;
    ++next;
  }
  return result;
}

VoxelMap<int>
labelVoxels(const VoxelMap<std::uint8_t>& occupancy,
            const VoxelMap<std::uint8_t>& interior,
            const PixelMap<int>& labels,
            int threads)
{
  requireMatching(occupancy, interior, labels);
  const GridShape& shape = occupancy.shape;
  VoxelMap<int> result;
  result.shape = shape;
  result.origin = occupancy.origin;
  result.voxel_size = occupancy.voxel_size;
  result.values.assign(shape.size(), -1);
  const std::vector<Offset> offsets = ball(voter_reach);
  // Reads only what no thread writes: the interior, the occupancy and the map.
  const auto freeLabel = [&](int x, int y, int z) {
    const std::size_t i = shape.index(x, y, z);
    return interior.values[i] && !occupancy.values[i] ? labels.at(x, y) : -1;
  };
  const auto labelOf = [&](Ballot& ballot, int x, int y, int z) {
    ballot.clear();
    int last = 0; // the distance up to which voxels vote, once it is known
    for (const Offset& o : offsets) {
      if (last > 0 && o.distance > last)
        break;
      if (!shape.contains(x + o.x, y + o.y, z + o.z))
        continue;
      const int label = freeLabel(x + o.x, y + o.y, z + o.z);
      if (label < 0)
        continue;
      ballot.vote(label, o.distance);
      if (ballot.votes() == label_voters)
        last = o.distance;
    }
    return ballot.winner();
  };
  parallelFor(
      shape.nx,
      usefulThreads(threads, shape.size(), 20000),
      4,
      [] { return Ballot(); },
      [&](Ballot& ballot, std::ptrdiff_t column) {
        const int x = static_cast<int>(column);
        for (int y = 0; y < shape.ny; ++y)
          for (int z = 0; z < shape.nz; ++z)
            result.at(x, y, z) =
                occupancy.at(x, y, z) ? labelOf(ballot, x, y, z) : freeLabel(x, y, z);
      });
  return result;
}

} // namespace pcl::indoor
