/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/split/object_gaps.h"

#include "objects/split/segment_parts.h"
#include "objects/split/slice_counts.h"

#include <pcl/indoor/ground_frame.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace {

using pcl::indoor::ObjectScene;
using pcl::indoor::SliceCounts;

using Members = pcl::indoor::SegmentMembers;

constexpr double farthest = 1 << 20; // extent of a segment, halves of voxels
constexpr double min_width = 0.5;    // of a gap, voxels
/** a gap holds at most this share of the points expected from the slices of its width
 * beside it: noise blurs its sides */
constexpr double remainder = 0.25;
/** and fewer than that by two standard deviations of a random count */
constexpr double deviations = 2;
/** a gap is this many times as wide as any other empty stretch near it (within four
 * times the least width): the spaces between the lines of a scanner are alike and do
 * not count */
constexpr double prominence = 1.5;

/** Gaps across one direction: where to cut, and how clear the clearest is. */
struct Cuts {
  double clearness = 0;            ///< points fewer than allowed; 0 = there is no gap
  pcl::indoor::SliceGrid grid;     ///< along the direction
  std::vector<std::size_t> slices; ///< ascending; the cuts lie at their beginnings
};

/** Points in slices of a quarter of a gap's least width. */
class Slices {
public:
  static constexpr std::ptrdiff_t per_gap = 4;

  explicit Slices(const SliceCounts& counts)
  : counts_(counts)
  {}

  /** The middle of the clearest place of each gap; sets how clear the clearest is. */
  std::vector<std::size_t>
  findGaps(double& clearness) const
  {
    std::vector<std::size_t> gaps;
    double best = 0; // of the gap that goes on
    for (std::ptrdiff_t i = reach; i + per_gap + reach <= size(); ++i) {
      const double here = clearnessOf(i);
      const auto middle = static_cast<std::size_t>(i + per_gap / 2);
      if (here > 0 && best == 0)
        gaps.push_back(middle);
      else if (here > best)
        gaps.back() = middle;
      best = here > 0 ? std::max(best, here) : 0;
      clearness = std::max(clearness, here);
    }
    return gaps;
  }

private:
  static constexpr std::ptrdiff_t reach = 2 * per_gap; // beside a gap

  std::ptrdiff_t
  size() const
  {
    return counts_.size();
  }

  double
  held(std::ptrdiff_t begin, std::ptrdiff_t end) const
  {
    return counts_.held(begin, end);
  }

  /** Points that a gap's width from slice i on lacks below what a gap may hold; 0 if it
   * is no gap. */
  double
  clearnessOf(std::ptrdiff_t i) const
  {
    const double beside =
        std::min(held(i - reach, i), held(i + per_gap, i + per_gap + reach));
    const double allowed = remainder * beside * per_gap / reach;
    const double rest = held(i, i + per_gap);
    // A count n of random points has a deviation of sqrt(n); of 0 that of 1 is taken.
    const double lacking = allowed - rest - deviations * std::sqrt(rest + 1);
    if (!(lacking > 0))
      return 0;
    // The front of furniture has fewer points than its sides, but is no gap.
    const double own = rest / per_gap;
    const double as_empty = own + deviations * std::sqrt(own + 1);
    return isWidest(i, std::min(allowed / per_gap, as_empty)) ? lacking : 0;
  }

  /** Whether no other empty stretch near the gap is nearly as wide. */
  bool
  isWidest(std::ptrdiff_t i, double allowed) const
  {
    auto begin = i, end = i + per_gap;
    while (begin > 0 && held(begin - 1, begin) <= allowed)
      --begin;
    while (end < size() && held(end, end + 1) <= allowed)
      ++end;
    const auto around = std::max(2 * reach, end - begin);
    const auto other = std::max(
        emptyStretch(std::max<std::ptrdiff_t>(begin - around, 0), begin, allowed),
        emptyStretch(end, std::min(end + around, size()), allowed));
    return static_cast<double>(end - begin) >= prominence * static_cast<double>(other);
  }

  /** The longest run of empty slices. */
  std::ptrdiff_t
  emptyStretch(std::ptrdiff_t first, std::ptrdiff_t last, double allowed) const
  {
    std::ptrdiff_t longest = 0, run = 0;
    for (auto slice = first; slice < last; ++slice) {
      run = held(slice, slice + 1) > allowed ? 0 : run + 1;
      longest = std::max(longest, run);
    }
    return longest;
  }

  const SliceCounts& counts_;
};

/** Cuts segments at their gaps, one after the other. */
class GapCutter {
public:
  explicit GapCutter(const ObjectScene& scene)
  : scene_(scene)
  , frame_(pcl::indoor::groundFrame(scene.up))
  {}

  /** \return the parts; one of all members if there is no gap */
  std::vector<Members>
  cutOnce(const Members& members) const
  {
    // A gap without points needs this many in the slices beside it.
    if (static_cast<double>(members.size()) * remainder <= 4 * deviations)
      return {members};
    std::vector<Eigen::Vector2f> places;
    places.reserve(members.size());
    const Eigen::Matrix<float, 2, 3> ground = frame_.topRows<2>().cast<float>();
    Eigen::AlignedBox2f box;
    for (const auto i : members) {
      places.emplace_back(ground * scene_.points[i]);
      box.extend(places.back());
    }
    if (box.sizes().maxCoeff() > farthest * scene_.voxel_size / 2)
      return {members};
    Cuts best;
    Eigen::Vector2f best_direction = Eigen::Vector2f::Zero();
    for (unsigned d = 0; d < pcl::indoor::level_directions; ++d) {
      const auto direction = pcl::indoor::levelDirection(d);
      auto cuts = cutsAcross(places, direction);
      if (cuts.clearness > best.clearness) {
        best = std::move(cuts);
        best_direction = direction;
      }
    }
    return cutAt(members, places, best_direction, best);
  }

private:
  Cuts
  cutsAcross(const std::vector<Eigen::Vector2f>& places,
             const Eigen::Vector2f& direction) const
  {
    std::vector<float> along;
    along.reserve(places.size());
    for (const auto& place : places)
      along.push_back(direction.dot(place));
    const SliceCounts counts(along, min_width * scene_.voxel_size / Slices::per_gap);
    Cuts cuts;
    cuts.grid = counts.grid();
    cuts.slices = Slices(counts).findGaps(cuts.clearness);
    return cuts;
  }

  std::vector<Members>
  cutAt(const Members& members,
        const std::vector<Eigen::Vector2f>& places,
        const Eigen::Vector2f& direction,
        const Cuts& cuts) const
  {
    std::vector<Members> parts(cuts.slices.size() + 1);
    for (std::size_t i = 0; i < members.size(); ++i) {
      const auto slice =
          static_cast<std::size_t>(cuts.grid.sliceAt(direction.dot(places[i])));
      const auto after =
          std::upper_bound(cuts.slices.begin(), cuts.slices.end(), slice);
      parts[static_cast<std::size_t>(after - cuts.slices.begin())].push_back(
          members[i]);
    }
    return parts;
  }

  const ObjectScene& scene_;
  Eigen::Matrix3d frame_;
};

} // namespace

namespace pcl::indoor {

void
partAtGaps(const ObjectScene& scene,
           const std::vector<std::uint8_t>& left_out,
           std::vector<std::uint32_t>& segment_of_point)
{
  const GapCutter cutter(scene);
  partSegments(
      scene,
      left_out,
      [&cutter](const Members& members) { return cutter.cutOnce(members); },
      segment_of_point);
}

} // namespace pcl::indoor
