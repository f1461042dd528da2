/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/split/object_gaps.h"

#include "objects/split/segment_parts.h"
#include "objects/split/slice_counts.h"
#include <pcl/indoor/ground_frame.h>

#include <pcl/exceptions.h>
#include <pcl/indoor/point_cells.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace {

using pcl::indoor::ObjectGapOptions;
using pcl::indoor::SliceCounts;

using Members = pcl::indoor::SegmentMembers;

constexpr double farthest = 1 << 20; // extent of a segment, halves of voxels

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

  Slices(const SliceCounts& counts, const ObjectGapOptions& options)
  : options_(options)
  , counts_(counts)
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
    const double allowed = options_.remainder * beside * per_gap / reach;
    const double rest = held(i, i + per_gap);
    // The count is random; its deviation is the root, and one more than none was seen.
    const double lacking = allowed - rest - options_.deviations * std::sqrt(rest + 1);
    if (!(lacking > 0))
      return 0;
    // Beside dense sides of furniture its front is thin, but no gap.
    const double own = rest / per_gap;
    const double as_empty = own + options_.deviations * std::sqrt(own + 1);
    return isWidest(i, std::min(allowed / per_gap, as_empty)) ? lacking : 0;
  }

  /** Whether what is beside the gap is solid, and no other empty stretch nearly as
   * wide. */
  bool
  isWidest(std::ptrdiff_t i, double allowed) const
  {
    auto begin = i, end = i + per_gap;
    while (begin > 0 && held(begin - 1, begin) <= allowed)
      --begin;
    while (end < size() && held(end, end + 1) <= allowed)
      ++end;
    const auto beside = std::max(emptyStretch(begin - reach, begin, allowed),
                                 emptyStretch(end, end + reach, allowed));
    if (beside >= per_gap)
      return false;
    const auto around = std::max(2 * reach, end - begin);
    const auto other = std::max(
        emptyStretch(std::max<std::ptrdiff_t>(begin - around, 0), begin, allowed),
        emptyStretch(end, std::min(end + around, size()), allowed));
    return static_cast<double>(end - begin) >=
           options_.prominence * static_cast<double>(other);
  }

  /** The longest run of empty slices; there is nothing beyond the first and the last.
   */
  std::ptrdiff_t
  emptyStretch(std::ptrdiff_t first, std::ptrdiff_t last, double allowed) const
  {
    std::ptrdiff_t longest = 0, run = 0;
    for (auto slice = first; slice < last; ++slice) {
      const bool is_inside = slice >= 0 && slice < size();
      run = is_inside && held(slice, slice + 1) > allowed ? 0 : run + 1;
      longest = std::max(longest, run);
    }
    return longest;
  }

  const ObjectGapOptions& options_;
  const SliceCounts& counts_;
};

/** Cuts segments at their gaps, one after the other. */
class GapCutter {
public:
  GapCutter(const std::vector<Eigen::Vector3f>& points, const ObjectGapOptions& options)
  : points_(points)
  , options_(options)
  , frame_(pcl::indoor::groundFrame(options.up))
  {}

  /** \return the parts; one of all members if there is no gap */
  std::vector<Members>
  partsOf(const Members& members) const
  {
    if (!isLargeEnough(members) || !isDense(members))
      return {members};
    return pcl::indoor::cutRepeatedly(
        members, [this](const Members& whole) { return cutOnce(whole); });
  }

private:
  /** A gap without points needs this many in the slices beside it. */
  bool
  isLargeEnough(const Members& members) const
  {
    return static_cast<double>(members.size()) * options_.remainder >
           4 * options_.deviations;
  }

  /** Whether points fill the voxels: the lines of a sparse scan do not, nor what
   * reaches farther than cells can be numbered. */
  bool
  isDense(const Members& members) const
  {
    std::vector<Eigen::Vector3f> places;
    places.reserve(members.size());
    Eigen::AlignedBox3d box;
    for (const auto i : members) {
      places.push_back(points_[i]);
      box.extend(points_[i].cast<double>());
    }
    if (box.sizes().maxCoeff() > farthest * options_.voxel_size / 2)
      return false;
    const auto voxels = pcl::indoor::groupByCell(places, options_.voxel_size).size();
    const auto halves =
        pcl::indoor::groupByCell(places, options_.voxel_size / 2).size();
    return static_cast<double>(halves) >=
           options_.min_density * static_cast<double>(voxels);
  }

  std::vector<Members>
  cutOnce(const Members& members) const
  {
    if (!isLargeEnough(members))
      return {members};
    std::vector<Eigen::Vector2f> places;
    places.reserve(members.size());
    const Eigen::Matrix<float, 2, 3> ground = frame_.topRows<2>().cast<float>();
    for (const auto i : members)
      places.emplace_back(ground * points_[i]);
    Cuts best;
    Eigen::Vector2f best_direction = Eigen::Vector2f::Zero();
    for (unsigned d = 0; d < options_.directions; ++d) {
      const auto direction = pcl::indoor::levelDirection(d, options_.directions);
      auto cuts = cutsAcross(places, direction);
      if (cuts.clearness > best.clearness) {
        best = std::move(cuts);
        best_direction = direction;
      }
    }
    return cutAt(members, places, best_direction, best);
  }

  Cuts
  cutsAcross(const std::vector<Eigen::Vector2f>& places,
             const Eigen::Vector2f& direction) const
  {
    std::vector<float> along;
    along.reserve(places.size());
    for (const auto& place : places)
      along.push_back(direction.dot(place));
    const SliceCounts counts(along,
                             options_.width * options_.voxel_size / Slices::per_gap);
    Cuts cuts;
    cuts.grid = counts.grid();
    cuts.slices = Slices(counts, options_).findGaps(cuts.clearness);
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

  const std::vector<Eigen::Vector3f>& points_;
  const ObjectGapOptions& options_;
  Eigen::Matrix3d frame_;
};

void
requireValid(std::size_t point_count,
             std::size_t flag_count,
             std::size_t segment_count,
             const ObjectGapOptions& options)
{
  if (flag_count != point_count || segment_count != point_count)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        point_count << " points have " << flag_count << " flags and "
                                    << segment_count << " segments.");
  const auto is_share = [](double value) { return value >= 0 && value <= 1; };
  if (!(options.voxel_size > 0) || !(options.width > 0) || options.directions < 1 ||
      !(options.deviations >= 0) || !is_share(options.remainder) ||
      !(options.prominence >= 0) || !(options.min_density >= 0) ||
      !(std::abs(options.up.norm() - 1) < 1e-3f))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Gaps need positive sizes, shares from 0 to 1 and a unit "
                        "vector up.");
}

} // namespace

namespace pcl {
namespace indoor {

void
partAtGaps(const std::vector<Eigen::Vector3f>& points,
           const std::vector<std::uint8_t>& left_out,
           const ObjectGapOptions& options,
           std::vector<std::uint32_t>& segment_of_point)
{
  requireValid(points.size(), left_out.size(), segment_of_point.size(), options);
  if (points.empty())
    return;
  const GapCutter cutter(points, options);
  partSegments(
      left_out,
      options.threads,
      [&cutter](const Members& members) { return cutter.partsOf(members); },
      segment_of_point);
}

} // namespace indoor
} // namespace pcl
